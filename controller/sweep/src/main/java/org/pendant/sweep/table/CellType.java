package org.pendant.sweep.table;

/** Cell type: what the cells of a column of results are. */
public enum CellType {
  /** A {@link Long}. */
  WHOLE,
  /** A {@link Double}, always finite. */
  NUMBER,
  /** A {@link String}. */
  TEXT
}
