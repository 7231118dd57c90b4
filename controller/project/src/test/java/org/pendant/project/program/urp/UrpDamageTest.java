package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.urp.UrpFixture.main;
import static org.pendant.project.program.urp.UrpFixture.refusal;
import static org.pendant.project.program.urp.UrpFixture.step;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;

/** Programs of PolyScope that are damaged, or made to do harm. */
class UrpDamageTest {
  @Test
  void refusesReferencesThatLeadInACircle() {
    String message =
        refusal(
            main(
                """
                <Timer action="Start"><variable reference="../../Timer[2]/variable"/></Timer>
                <Timer action="Stop"><variable reference="../../Timer/variable"/></Timer>
                """));
    assertTrue(message.startsWith("pick.urp:4:23: error: its reference "), message);
    assertTrue(message.contains("leads in a circle"), message);
  }

  @Test
  void refusesWhatIsNoXml() {
    assertTrue(refusal("no xml").startsWith("pick.urp:1:1: error: is no XML: "));
    assertTrue(refusal("").contains("error: is no XML: "));
    assertTrue(refusal("<URProgram>\n  <a></b>").startsWith("pick.urp:2:"));
    assertEquals(
        "pick.urp: error: is no text in UTF-8", refusal(new byte[] {'<', (byte) 0xff, '>'}));
  }

  @Test
  void readsNothingThatTheFileOnlyPointsTo() {
    String outside =
        "<!DOCTYPE URProgram [<!ENTITY secret SYSTEM \"file:///etc/hostname\">]>"
            + "<URProgram name=\"&secret;\"/>";
    assertTrue(refusal(outside).startsWith("pick.urp:1:"), refusal(outside));
    assertTrue(
        refusal("<!-- --><!DOCTYPE a [<!ENTITY b \"c\">]><URProgram>&b;</URProgram>")
            .startsWith("pick.urp:1:"));
  }

  @Test
  void refusesEveryCut() {
    byte[] whole = PackedXml.packed(main("<Halt/>"));
    for (int length = 0; length < whole.length - 1; length++) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThrows(UnreadableFile.class, () -> UrpPrograms.read("x.urp", part), "cut at " + length);
    }
  }

  @Test
  void refusesAFileThatUnpacksWithoutEnd() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream zip = new GZIPOutputStream(bytes)) {
      byte[] blanks = new byte[1 << 20];
      for (int i = 0; i < 65; i++) {
        zip.write(blanks);
      }
    }
    assertEquals(
        "pick.urp: error: has more than 67108864 bytes when unpacked",
        refusal(bytes.toByteArray()));
  }

  @Test
  void refusesElementsThatAreTooDeep() {
    String deep = "<Folder><children>".repeat(400) + "</children></Folder>".repeat(400);
    assertTrue(refusal(main(deep)).contains("nodes are more than 200 levels deep"));
    String deeper = "<a>".repeat(5000) + "</a>".repeat(5000);
    assertTrue(refusal(deeper).contains("elements stand more than 1000 deep in each other"));
  }

  @Test
  void readsTextsOfAnyLength() throws UnreadableFile {
    String code = "&lt;&amp;&#65;".repeat(100_000);
    String xml =
        "<Script type=\"File\"><cachedContents>" + code + "</cachedContents><file/></Script>";
    assertEquals(new ActionStep.ScriptFile("", List.of("<&A".repeat(100_000))), step(xml));
  }
}
