package org.pendant.language.service;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Node;

/** Enclosing ranges: the pieces of syntax around a place in a text, each in the next. */
final class Enclosing {
  private Enclosing() {}

  /**
   * Ranges around {@code offset}, the smallest first; each is larger than the one before.
   *
   * @param word the word or sign at the offset, which is the smallest of all
   */
  static List<SourceRange> of(Node root, int offset, List<SourceRange> word) {
    List<SourceRange> outermostFirst = new ArrayList<>();
    Node node = root;
    while (node != null) {
      outermostFirst.add(node.range());
      node = childAt(node, offset);
    }
    outermostFirst.addAll(word);
    List<SourceRange> growing = new ArrayList<>();
    for (SourceRange range : outermostFirst.reversed()) {
      if (growing.isEmpty() || contains(range, growing.getLast())) {
        growing.add(range);
      }
    }
    return List.copyOf(growing);
  }

  private static Node childAt(Node node, int offset) {
    for (Node child : node.children()) {
      if (child.range().start() <= offset && offset <= child.range().end()) {
        return child;
      }
    }
    return null;
  }

  private static boolean contains(SourceRange outer, SourceRange inner) {
    return outer.start() <= inner.start() && inner.end() <= outer.end() && !outer.equals(inner);
  }
}
