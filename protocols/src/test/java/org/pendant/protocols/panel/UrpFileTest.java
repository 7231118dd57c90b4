package org.pendant.protocols.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Set;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;

class UrpFileTest {
  private static final String TREE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <URProgram name="pick" installation="cell" createdIn="5.24.1" lastSavedIn="5.24.1">
        <kinematics status="LINEARIZED"><deltaTheta value="0.0"/></kinematics>
        <children>
          <MainProgram runOnlyOnce="false">
            <children>
              <Move motionType="MoveJ">
                <children>
                  <Waypoint type="Fixed" name="Waypoint_1"><position joints="0, 0, 0"/></Waypoint>
                  <Waypoint type="Fixed" name="Waypoint_2"><position joints="1, 0, 0"/></Waypoint>
                </children>
              </Move>
              <Wait type="Sleep"><waitTime>0.5</waitTime></Wait>
            </children>
          </MainProgram>
        </children>
      </URProgram>
      """;

  private static byte[] zipped(String text) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream zip = new GZIPOutputStream(bytes)) {
      zip.write(text.getBytes(StandardCharsets.UTF_8));
    }
    return bytes.toByteArray();
  }

  private static String refusal(byte[] bytes) {
    return assertThrows(IOException.class, () -> UrpFile.read(bytes)).getMessage();
  }

  @Test
  void readsNamesAndKindsOfNodes() throws IOException {
    assertEquals(
        new UrpFile("pick", "cell", Set.of("MainProgram", "Move", "Waypoint", "Wait")),
        UrpFile.read(zipped(TREE)));
  }

  @Test
  void refusesWhatIsNotCompressed() {
    assertEquals("Not in GZIP format", refusal(TREE.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void refusesOtherFiles() throws IOException {
    assertEquals("holds a Installation, must hold a URProgram", refusal(zipped("<Installation/>")));
    assertTrue(refusal(zipped("no xml")).startsWith("is no XML: "));
    assertTrue(refusal(zipped("<URProgram><children>")).startsWith("is no XML: "));
  }

  @Test
  void readsNothingThatTheFileOnlyPointsTo() throws IOException {
    String outside =
        "<!DOCTYPE URProgram [<!ENTITY secret SYSTEM \"file:///etc/hostname\">]>"
            + "<URProgram name=\"&secret;\"/>";
    assertTrue(refusal(zipped(outside)).startsWith("is no XML: "));
  }

  @Test
  void refusesEveryCut() throws IOException {
    byte[] whole = zipped(TREE);
    for (int length = 0; length < whole.length - 1; length += 7) {
      byte[] part = Arrays.copyOf(whole, length);
      assertThrows(IOException.class, () -> UrpFile.read(part), "cut at " + length);
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
    assertTrue(refusal(bytes.toByteArray()).startsWith("has more than 67108864 bytes"));
  }
}
