package org.pendant.language.service;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Units of numbers by their place; {@code |} is where the pointer stands. */
final class QuantityTest {

  private static String at(String marked) {
    Marked place = Marked.of(marked);
    return place
        .analysis()
        .quantity(place.caret())
        .map(found -> found.name() + " " + found.value() + " " + found.unit().symbol())
        .orElse("none");
  }

  @Test
  void anArgumentHasTheUnitOfItsParameter() {
    assertEquals("t 0.5 s", at("sleep(0|.5)"));
    assertEquals("a 1.2 rad/s²", at("movej(q, |1.2)"));
    assertEquals("v 3.0 rad/s", at("movej(q, v=|3)"));
    assertEquals("t -2.0 s", at("sleep(|-2)"));
  }

  @Test
  void partsOfPosesAreLengthsAndRotations() {
    assertEquals("y -0.25 m", at("place = p[0, -0|.25, 0, 0, 3.14, 0]"));
    assertEquals("ry 3.14 rad", at("place = p[0, -0.25, 0, 0, 3|.14, 0]"));
    assertEquals("z 0.3 m", at("movel(p[0, 0, |0.3, 0, 0, 0])"));
  }

  @Test
  void jointsThatACallTakesAreAngles() {
    assertEquals("q[1] -1.57 rad", at("movej([0, -1|.57, 0, 0, 0, 0])"));
    assertEquals("none", at("other = [0, -1|.57, 0, 0, 0, 0]"));
    assertEquals("none", at("textmsg([0, -1|.57])"));
  }

  @Test
  void whatIsComputedWithHasNoUnit() {
    assertEquals("none", at("sleep(2 * |3)"));
    assertEquals("none", at("sleep(|3 + 1)"));
    assertEquals("none", at("x = |3"));
    assertEquals("none", at("textmsg(|3)"));
    assertEquals("none", at("slee|p(3)"));
  }
}
