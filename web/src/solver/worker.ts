// Glue alone: see serve-module.ts.
import createLiftarmCore from '@wasm/liftarm-core.js';
import wasmUrl from '@wasm/liftarm-core.wasm?url';
import { serveModule } from './serve-module.ts';

serveModule(createLiftarmCore, wasmUrl);
