// Made by `uv run python -m tests.page.generate` from app/words/en.
/** The keys of all texts, and the names of their places. */
export type Words = {
  "access-title": never;
  "access-language": never;
  "access-language.hint": never;
  "access-letters": never;
  "access-letters.hint": never;
  "access-letters.always": never;
  "access-letters.body": never;
  "access-letters.never": never;
  "access-larger": never;
  "access-larger.hint": never;
  "access-still": never;
  "access-still.hint": never;
  "access-kept": never;
  "class-title": never;
  "class-needs-javascript": never;
  "class-blocked": never;
  "language-name": never;
  "language-direction": never;
  "canvas-body": never;
  "line-away": never;
};
