// What the scripts about the gallery take from the page: the catalogue, the renderer, the gears, links.
import catalogueFile from '../../core/parts/catalogue.json';
import { readCatalogue } from '../../web/src/model/catalogue.ts';
import { encodeShare } from '../../web/src/share/codec.ts';
import { PREFERENCE_DEFAULTS } from '../../web/src/state/preferences.ts';
import { placeTrain, readGearTrain, withTrain } from '../../web/src/ui/gallery/gear-train.ts';
import { settingsOf } from '../../web/src/ui/solve-settings.ts';
import { cameraFor, ISO_OUT } from '../../web/src/view/drawing/drawing-camera.ts';
import { drawn, MeshShelf } from '../../web/src/view/drawing/drawn-part.ts';
import { drawPicture } from '../../web/src/view/drawing/picture.ts';
import { writeStl } from '../../web/src/view/export/stl.ts';

const catalogue = readCatalogue(catalogueFile);

export const tools = {
  catalogue,
  /** What the page asks for at first. */
  settings: settingsOf(PREFERENCE_DEFAULTS),
  shelf: new MeshShelf(catalogue),
  placeTrain,
  readGearTrain,
  withTrain,
  encodeShare,
  cameraFor,
  ISO_OUT,
  drawn,
  drawPicture,
  writeStl,
};
