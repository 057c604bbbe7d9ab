// Made by `uv run python -m tests.page.generate` from app/words/en.
/** The keys of all texts, and the names of their places. */
export type Words = {
  "class-title": never;
  "class-needs-javascript": never;
  "class-blocked": never;
  "language-name": never;
  "language-direction": never;
  "canvas-body": never;
  "line-away": never;
};
