// Tables that readers sort by a click on a column's head and filter by words.

const valueOf = (cell) => {
  const exact = cell.dataset.sort ?? cell.dataset.value ?? cell.textContent;
  if (exact === 'null' || cell.textContent === '–') return null;
  const number = Number(exact);
  return exact.trim() !== '' && !Number.isNaN(number) ? number : cell.textContent;
};

function compare(a, b) {
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return String(a).localeCompare(String(b), 'en');
}

/** Rows in the order of a column; what was not measured comes last in either direction. */
function sortBy(table, column, descending) {
  const body = table.tBodies[0];
  const rows = Array.from(body.rows, (row) => ({ row, value: valueOf(row.cells[column]) }));
  rows.sort((a, b) => {
    if (a.value === null || b.value === null) return (a.value === null) - (b.value === null);
    return (descending ? -1 : 1) * compare(a.value, b.value);
  });
  body.append(...rows.map(({ row }) => row));
}

function makeSortable(table) {
  const heads = Array.from(table.tHead.rows[0].cells);
  heads.forEach((head, column) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'sort';
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener('click', () => {
      const descending = head.getAttribute('aria-sort') === 'ascending';
      heads.forEach((other) => other.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
      sortBy(table, column, descending);
    });
  });
}

/** Words are looked for anywhere in a row, numbers must be a whole cell: 0.1 is not meant to find 0.1179. */
const holds = (row, word) =>
  Number.isNaN(Number(word))
    ? row.textContent.toLowerCase().includes(word)
    : Array.from(row.cells).some((cell) => cell.textContent.trim() === word);

/** A field above the table that leaves rows with all of its words. */
function makeFilterable(table) {
  const label = document.createElement('label');
  label.className = 'filter';
  const field = document.createElement('input');
  field.type = 'search';
  field.placeholder = 'cog 0.1';
  const count = document.createElement('span');
  count.setAttribute('role', 'status');
  label.append('Rows with ', field, count);
  table.parentElement.before(label);
  field.addEventListener('input', () => {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const rows = Array.from(table.tBodies[0].rows);
    rows.forEach((row) => {
      row.hidden = !words.every((word) => holds(row, word));
    });
    count.textContent = words.length > 0 ? ` ${rows.filter((row) => !row.hidden).length} of ${rows.length}` : '';
  });
}

/** Every table with class "sortable" on the page. */
export function setUpTables() {
  document.querySelectorAll('table.sortable').forEach((table) => {
    makeSortable(table);
    if (table.tBodies[0].rows.length > 4) makeFilterable(table);
  });
}
