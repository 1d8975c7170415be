// Light or dark: as the system, or as the reader chose. Colours stand in page.css alone.

const listeners = [];
let chosen = 'auto';

const systemIsDark = matchMedia('(prefers-color-scheme: dark)');

export const themeNow = () => (chosen === 'auto' ? (systemIsDark.matches ? 'dark' : 'light') : chosen);

/** The value of a custom property of page.css. */
export const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** Calls `listener` whenever colours have changed. */
export const onTheme = (listener) => listeners.push(listener);

function apply(theme) {
  if (theme === 'auto') delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  listeners.forEach((listener) => listener());
}

function remember(theme) {
  chosen = theme;
  try {
    localStorage.setItem('cogslam-theme', theme);
  } catch {
    // A browser may forbid it; the page then follows the system next time.
  }
  apply(theme);
}

function remembered() {
  try {
    const theme = localStorage.getItem('cogslam-theme');
    return theme === 'light' || theme === 'dark' ? theme : 'auto';
  } catch {
    return 'auto';
  }
}

/** Adds the switch to the header. */
export function setUpTheme(header) {
  chosen = remembered();
  const button = document.createElement('button');
  button.id = 'theme';
  button.type = 'button';
  const name = () => {
    const other = themeNow() === 'dark' ? 'light' : 'dark';
    button.textContent = other === 'dark' ? '☾ dark' : '☀ light';
    button.setAttribute('aria-label', `Use ${other} colours`);
  };
  button.addEventListener('click', () => remember(themeNow() === 'dark' ? 'light' : 'dark'));
  header.append(button);
  onTheme(name);
  systemIsDark.addEventListener('change', () => apply(chosen));
  // Paper is white.
  addEventListener('beforeprint', () => apply('light'));
  addEventListener('afterprint', () => apply(chosen));
  apply(chosen);
}
