package org.pendant.project.installation.urp;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.project.polyscope.xml.XmlElement;

/** Rows of values that stand in one attribute with commas between. */
final class Rows {
  private Rows() {}

  /** Numbers; none if there are not so many, or one is not a finite number. */
  static double[] numbers(String text, int count) {
    try {
      double[] numbers =
          Arrays.stream(text.split(",", -1)).mapToDouble(Double::parseDouble).toArray();
      boolean right = numbers.length == count && Arrays.stream(numbers).allMatch(Double::isFinite);
      return right ? numbers : new double[0];
    } catch (NumberFormatException e) {
      return new double[0];
    }
  }

  /** Words in the element of a name; none if it is not there. */
  static List<String> words(Optional<XmlElement> parent, String name) {
    String text =
        parent.flatMap(each -> each.child(name)).map(each -> each.text("value")).orElse("");
    return text.isEmpty()
        ? List.of()
        : Arrays.stream(text.split(",", -1)).map(String::strip).toList();
  }
}
