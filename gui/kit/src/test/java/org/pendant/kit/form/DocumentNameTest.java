package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class DocumentNameTest {

  @Test
  void whatStandsBehindTheNameStaysWhenTheDocumentIsChanged() {
    DocumentName name = new DocumentName("scene-name");
    name.show("table.scene.json", false);
    int saved = name.getPreferredSize().width;
    name.show("table.scene.json", true);
    assertEquals("\u2022 table.scene.json", name.getText());
    assertEquals(saved, name.getPreferredSize().width);
  }
}
