// Packs sheets of answers by the script of live files: reads one JSON object a line, writes the text and its QR code.
import { createInterface } from "node:readline";
import "./words.mjs";
import { packed } from "../../app/export/live/static/answers.js";
import { qrCode } from "../../app/export/live/static/qr.js";

for await (const line of createInterface({ input: process.stdin })) {
  const { sheet, frame } = JSON.parse(line);
  const { text, left } = packed(sheet, frame);
  console.log(JSON.stringify({ text, left, code: qrCode(text).map((row) => row.map(Number)) }));
}
