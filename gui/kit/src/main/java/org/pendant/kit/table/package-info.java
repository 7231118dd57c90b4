/**
 * Tables: rows with titles above them. Open {@link org.pendant.kit.table.RowsModel} for what a
 * table shows, {@link org.pendant.kit.table.TableLook} for how it looks.
 */
package org.pendant.kit.table;
