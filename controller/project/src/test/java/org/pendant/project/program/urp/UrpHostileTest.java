package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ProgramTree;

/** Files that are damaged, or made to do harm. */
@Tag("slow")
class UrpHostileTest {
  private static final String SAMPLE =
      """
      <?xml version="1.0" encoding="UTF-8" standalone="no"?>
      <!-- saved -->
      <URProgram name="pick" installation="cell"><kinematics status="x"/><children>
      <InitVariablesNode/><MainProgram runOnlyOnce="true"><children>
      <Assignment valueSource="Expression"><variable name="n"><initializeExpression/></variable>
      <expression><ExpressionChar character="&quot;"/><ExpressionToken token=" True "/></expression>
      </Assignment>
      <Move motionType="MoveJ" speed="1.0" acceleration="1.4"><feature referencedName="F"/><children>
      <Waypoint type="Fixed" name="A"><motionParameters blendRadius="0.1"/><position>
      <JointAngles angles="0, 0, 0, 0, 0, 0"/><TCPOffset pose="0, 0, 0, 0, 0, 0"/></position>
      <BaseToFeature pose="0, 0, 0, 0, 0, 1"/></Waypoint></children></Move>
      <Loop type="While"><expression><ExpressionVariable><ProgramVariable
       reference="../../../../Assignment/variable"/></ExpressionVariable></expression>
      <children><SuppressedNode><Halt/></SuppressedNode></children></Loop>
      <Script type="File"><cachedContents><![CDATA[a < b]]></cachedContents><file>f</file></Script>
      <CallSubProgram><subprogram name="S"><children><Weld a='<'/></children></subprogram>
      </CallSubProgram></children></MainProgram>
      <SubProgram reference="../MainProgram/children/CallSubProgram/subprogram"/>
      </children></URProgram>
      """
          .replace("a='<'", "a='>'");

  private static final String PIECES = "<>/\"'=&;-![]?. \n\tabAZ019_CD";

  private static ProgramTree read(String xml) throws UnreadableFile {
    return UrpPrograms.read("x.urp", xml.getBytes(StandardCharsets.UTF_8)).tree();
  }

  @Test
  void damagedFilesAreRefusedOrReadAndKept() throws UnreadableFile {
    read(SAMPLE);
    Random random = new Random(7);
    int whole = 0;
    for (int turn = 0; turn < 3000; turn++) {
      StringBuilder xml = new StringBuilder(SAMPLE);
      for (int i = 1 + random.nextInt(3); i > 0; i--) {
        int at = random.nextInt(xml.length());
        int length = Math.min(random.nextInt(6), xml.length() - at);
        int from = random.nextInt(PIECES.length());
        int to = from + random.nextInt(PIECES.length() - from);
        xml.replace(at, at + length, random.nextBoolean() ? PIECES.substring(from, to) : "");
      }
      try {
        ProgramTree tree = read(xml.toString());
        whole++;
        assertEquals(
            tree, UrpPrograms.read("x.urp", UrpPrograms.write("x", tree)).tree(), xml::toString);
      } catch (UnreadableFile e) {
        assertTrue(e.report("x.urp").startsWith("x.urp:"), e::getMessage);
      }
    }
    assertTrue(whole > 100, "only " + whole + " could be read");
  }

  @Test
  void followsManyReferencesAmongManyElements() throws UnreadableFile {
    int count = 20_000;
    String nodes =
        "<Timer action=\"Start\"><variable name=\"t\"/></Timer>".repeat(count)
            + ("<Timer action=\"Stop\"><variable reference=\"../../Timer["
                    + count
                    + "]/variable\"/>"
                    + "</Timer>")
                .repeat(count);
    ProgramTree tree =
        read(
            "<URProgram><children><MainProgram><children>"
                + nodes
                + "</children></MainProgram></children></URProgram>");
    assertEquals(2 * count + 1, tree.nodes().size());
  }

  @Test
  void refusesChainsOfReferencesWithoutEnd() {
    StringBuilder nodes = new StringBuilder();
    for (int i = 1; i <= 3000; i++) {
      nodes
          .append("<Timer action=\"Start\"><variable reference=\"../../Timer[")
          .append(i + 1)
          .append("]/variable\"/></Timer>");
    }
    String xml =
        "<URProgram><children><MainProgram><children>"
            + nodes
            + "</children></MainProgram></children></URProgram>";
    UnreadableFile refused = assertThrows(UnreadableFile.class, () -> read(xml));
    assertEquals("its reference leads through more than 1000 others", refused.getMessage());
  }

  @Test
  void doesNotCopySubProgramsForEachReference() {
    String big = "<Halt/>".repeat(20_000);
    String references =
        "<SubProgram reference=\"../MainProgram/children/CallSubProgram/subprogram\"/>"
            .repeat(20_000);
    String xml =
        "<URProgram><children><MainProgram><children><CallSubProgram><subprogram name=\"s\">"
            + "<children>"
            + big
            + "</children></subprogram></CallSubProgram></children></MainProgram>"
            + references
            + "</children></URProgram>";
    UnreadableFile refused = assertThrows(UnreadableFile.class, () -> read(xml));
    assertTrue(refused.getMessage().contains("is one node too many"), refused::getMessage);
  }
}
