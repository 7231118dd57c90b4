/**
 * Tables of results. Open {@link org.pendant.sweep.table.ResultTable} first: it says which columns
 * a plan has; {@link org.pendant.sweep.table.CsvRows} writes and reads their rows.
 */
package org.pendant.sweep.table;
