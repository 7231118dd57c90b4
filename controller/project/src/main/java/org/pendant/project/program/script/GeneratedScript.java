package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ProgramNode;

/**
 * Generated script of a program tree.
 *
 * @param text all of it; lines end with a line feed
 * @param places which lines belong to which node, in the order of the nodes' line numbers; a node
 *     that generates nothing has none
 * @param received which lines a driver has sent, see {@link ControlScript}, in their order
 * @param names that it has besides those that people gave
 */
public record GeneratedScript(
    String text, List<NodeLines> places, List<Received> received, GeneratedNames names) {
  /** Without anything in it. */
  public static final GeneratedScript EMPTY =
      new GeneratedScript("", List.of(), List.of(), GeneratedNames.NONE);

  /**
   * The lines of one node.
   *
   * @param key of the {@link ProgramNode}
   * @param number of the node in the tree, from 1, as in the label of the script
   * @param first line of its own, from 1: where a breakpoint on the node stops
   * @param last line that belongs to it or a node below it
   */
  public record NodeLines(long key, int number, int first, int last) {}

  /**
   * Lines that follow each other in the text that was received as well.
   *
   * @param first of them, from 1
   * @param last of them
   * @param from number of the first one in the text that was received, from 1
   */
  public record Received(int first, int last, int from) {}

  public GeneratedScript {
    places = List.copyOf(places);
    received = List.copyOf(received);
  }

  /** Where a node is. */
  public Optional<NodeLines> of(long key) {
    return places.stream().filter(each -> each.key() == key).findFirst();
  }

  /** The innermost node that a line belongs to. */
  public Optional<NodeLines> at(int line) {
    return places.stream()
        .filter(each -> each.first() <= line && line <= each.last())
        .reduce((outer, inner) -> inner);
  }

  /** Which line of the text that a driver has sent a line is; empty if it is none. */
  public OptionalInt receivedLine(int line) {
    return received.stream()
        .filter(each -> each.first() <= line && line <= each.last())
        .mapToInt(each -> each.from() + line - each.first())
        .findFirst();
  }
}
