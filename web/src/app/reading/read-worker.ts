// Reads one file, away from the page: a file can be made so that reading it takes for ever.

import type { ReadRequest } from './file-reader.ts';
import { parseFile } from './parse-file.ts';

addEventListener('message', ({ data }: MessageEvent<ReadRequest>) => {
  postMessage(parseFile(data.content, data.parts, data.name));
});
