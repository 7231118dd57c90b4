package org.pendant.controller.program.script;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.program.ProgramNode;

/**
 * The script of a program tree.
 *
 * @param text all of it; lines end with a line feed
 * @param places which lines belong to which node, in the order of the nodes' line numbers; a node
 *     that generates nothing has none
 */
public record GeneratedScript(String text, List<Place> places) {

  /**
   * The lines of one node.
   *
   * @param key of the {@link ProgramNode}
   * @param number of the node in the tree, from 1, as in the label of the script
   * @param first line of its own, from 1: where a breakpoint on the node stops
   * @param last line that belongs to it or a node below it
   */
  public record Place(long key, int number, int first, int last) {}

  public GeneratedScript {
    places = List.copyOf(places);
  }

  /** Where a node is. */
  public Optional<Place> of(long key) {
    return places.stream().filter(each -> each.key() == key).findFirst();
  }

  /** The innermost node that a line belongs to. */
  public Optional<Place> at(int line) {
    return places.stream()
        .filter(each -> each.first() <= line && line <= each.last())
        .reduce((outer, inner) -> inner);
  }
}
