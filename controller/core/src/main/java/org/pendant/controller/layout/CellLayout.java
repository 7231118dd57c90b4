package org.pendant.controller.layout;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Layout of a cell: which controllers share it. Arms come first, in the order of the file, and step
 * in this order within each frame; the controller of the cell's script, which has no arm, is the
 * last.
 *
 * @param arms at most {@value #MAX_ARMS}; empty for a cell with one arm of which the file says
 *     nothing
 * @param script what the controller without an arm runs; empty where there is none
 */
public record CellLayout(List<ArmEntry> arms, Optional<NamedFile> script) {
  /** Arms in a cell at most. */
  public static final int MAX_ARMS = 8;

  /** What the controller of the cell's script is called. */
  public static final String SCRIPT_OWNER = "cell";

  /** What the only arm of a cell with a script is called where the file names none. */
  public static final String ONLY_ARM = "arm";

  /** One arm of which the file says nothing. */
  public static final CellLayout ALONE = new CellLayout(List.of(), Optional.empty());

  /** The list is copied. */
  public CellLayout {
    arms = List.copyOf(arms);
  }

  /** Whether there is one controller alone. */
  public boolean alone() {
    return arms.isEmpty() && script.isEmpty();
  }

  /** The names of the controllers; none where there is one alone. */
  public List<String> names() {
    if (alone()) {
      return List.of();
    }
    List<String> names = new ArrayList<>(arms.stream().map(ArmEntry::name).toList());
    if (names.isEmpty()) {
      names.add(ONLY_ARM);
    }
    if (script.isPresent()) {
      names.add(SCRIPT_OWNER);
    }
    return names;
  }
}
