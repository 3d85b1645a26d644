// Glue alone: see serve-module.ts.
import createLiftarmLab from '@wasm/liftarm-lab.js';
import wasmUrl from '@wasm/liftarm-lab.wasm?url';
import { serveModule } from '../serve-module.ts';

serveModule(createLiftarmLab, wasmUrl);
