package org.pendant.desktop.debug;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/**
 * Value order: which variables are shown, and which of them come first.
 *
 * @param filter words that a name must have, upper and lower case alike
 * @param favourite whether the variable of this expression is one
 * @param hidden whether the variable of this expression is shown only when it is a favourite or
 *     {@code filter} asks for it
 */
record ValueOrder(String filter, Predicate<String> favourite, Predicate<String> hidden) {
  /** All of them as they come, none a favourite. */
  static final ValueOrder PLAIN = new ValueOrder("", expression -> false, expression -> false);

  /** The nodes in sight, favourites first. */
  List<ValueNode> of(List<ValueNode> nodes) {
    String[] words = filter.strip().toLowerCase(Locale.ROOT).split("\\s+");
    List<ValueNode> first = new ArrayList<>();
    List<ValueNode> others = new ArrayList<>();
    for (ValueNode node : nodes) {
      if (favourite.test(node.variable().expression())) {
        if (matches(node.variable().name(), words)) {
          first.add(node);
        }
      } else if (matches(node.variable().name(), words)
          && !(filter.isBlank() && hidden.test(node.variable().expression()))) {
        others.add(node);
      }
    }
    first.addAll(others);
    return first;
  }

  private static boolean matches(String name, String[] words) {
    String text = name.toLowerCase(Locale.ROOT);
    for (String word : words) {
      if (!text.contains(word)) {
        return false;
      }
    }
    return true;
  }
}
