// Holds models against the Khronos validator of glTF: arguments are the folder where it is installed, and files.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const { validateBytes } = createRequire(join(folder, "/"))("gltf-validator");

for (const file of files) {
  const { issues } = await validateBytes(new Uint8Array(readFileSync(file)));
  if (issues.numErrors + issues.numWarnings === 0) continue;
  process.exitCode = 1;
  console.error(file, issues.messages.filter(({ severity }) => severity < 2).slice(0, 5));
}
