package org.pendant.controller.quantity;

/** The type of each number of a quantity. All are kept as doubles, which holds each of them. */
public enum ScalarType {
  BOOL,
  UINT8,
  INT32,
  UINT32,
  /** A count or bits, below 2^53. */
  UINT64,
  DOUBLE
}
