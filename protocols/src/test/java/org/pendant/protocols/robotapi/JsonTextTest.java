package org.pendant.protocols.robotapi;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class JsonTextTest {
  @Test
  void writesMembersInTheirOrder() {
    assertEquals("{}", new JsonText().text());
    assertEquals(
        "{\"a\":\"b\",\"c\":12,\"d\":{\"e\":\"\"},\"f\":[],\"g\":[{},{\"h\":-1}]}",
        new JsonText()
            .with("a", "b")
            .with("c", 12)
            .with("d", new JsonText().with("e", ""))
            .with("f", List.of())
            .with("g", List.of(new JsonText(), new JsonText().with("h", -1)))
            .text());
  }

  @Test
  void whatATextMayNotHaveIsWrittenOut() {
    assertEquals(
        "{\"a\\\"\":\"\\\\ \\u0000\\n\\u001F\u007f\u00e9\"}",
        new JsonText().with("a\"", "\\ \0\n\u001f\u007f\u00e9").text());
  }
}
