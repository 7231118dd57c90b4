package org.pendant.testing.coverage;

import java.util.BitSet;
import java.util.List;

/** Test names: the sorted names of tests that are known by their numbers. */
@FunctionalInterface
interface TestNames {
  List<String> of(BitSet numbers);
}
