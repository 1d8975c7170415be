// The page of a sweep.

import { SweepCurves } from './sweep_curves.js';
import { setUpTables } from './table.js';
import { setUpTheme, themeNow } from './theme.js';

setUpTheme(document.querySelector('header'));
setUpTables();
const data = JSON.parse(document.getElementById('sweep-data').textContent);
const curves = new SweepCurves(data, document.getElementById('curves'));

// For tests.
window.cogslam = {
  ready: Promise.resolve(),
  state: () => ({ ...curves.state(), theme: themeNow() }),
};
performance.mark('cogslam-ready');
