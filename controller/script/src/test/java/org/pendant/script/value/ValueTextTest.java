package org.pendant.script.value;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.script.value.Make.bools;
import static org.pendant.script.value.Make.floats;
import static org.pendant.script.value.Make.ints;
import static org.pendant.script.value.Make.list;
import static org.pendant.script.value.Make.matrix;
import static org.pendant.script.value.Make.pose;
import static org.pendant.script.value.Make.strings;
import static org.pendant.script.value.Make.struct;

import org.junit.jupiter.api.Test;

class ValueTextTest {

  @Test
  void everyKindOfValueHasItsText() throws ScriptError {
    assertEquals("None", NoneValue.NONE.text());
    assertEquals("True", Value.of(true).text());
    assertEquals("-12", Value.of(-12).text());
    assertEquals("as \"it\" is", Value.of("as \"it\" is").text());
    assertEquals("p[1, 2, 3, 4, 5, 6]", pose(1, 2, 3, 4, 5, 6).text());
    assertEquals("[1, 2, 3]", ints(1, 2, 3).text());
    assertEquals("[0.5, 1]", floats(0.5, 1).text());
    assertEquals("[True, False]", bools(true, false).text());
    assertEquals("[]", ints().text());
    assertEquals("[\"a\", \"b\"]", strings("a", "b").text());
    assertEquals("[p[0, 0, 0, 0, 0, 1]]", list(pose(0, 0, 0, 0, 0, 1)).text());
    assertEquals("[[1, 2], [3, 4]]", matrix(ints(1, 2), ints(3, 4)).text());
    assertEquals("{a = 1, b = \"x\"}", struct("a", 1, "b", "x").text());
    assertEquals("{in = {n = 0.5}}", struct("in", struct("n", 0.5)).text());
  }

  @Test
  void textThatIsTooLongKeepsItsClosingBracket() {
    assertEquals("[1, 2, 3]", ValueText.shortened(ints(1, 2, 3), 9));
    assertEquals("[1, ...]", ValueText.shortened(ints(1, 2, 3), 8));
    assertEquals("{a =...}", ValueText.shortened(struct("a", 123456), 8));
  }
}
