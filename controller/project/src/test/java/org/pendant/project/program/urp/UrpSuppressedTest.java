package org.pendant.project.program.urp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.urp.UrpFixture.main;
import static org.pendant.project.program.urp.UrpFixture.nodes;
import static org.pendant.project.program.urp.UrpFixture.program;
import static org.pendant.project.program.urp.UrpFixture.read;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;

/** Nodes of PolyScope's programs that are switched off. */
class UrpSuppressedTest {
  @Test
  void suppressesWhatIsSuppressedInEitherForm() throws UnreadableFile {
    List<ProgramNode> nodes =
        nodes(
            """
            <SuppressedNode><Folder name="a"><children><Halt/></children></Folder></SuppressedNode>
            <SuppressedNode><children><Halt/><Halt/></children></SuppressedNode>
            <Halt/>
            """);
    assertEquals(
        List.of(true, true, true, false), nodes.stream().map(ProgramNode::suppressed).toList());
    assertFalse(nodes.getFirst().children().getFirst().suppressed());
  }

  @Test
  void aNodeThatIsSwitchedOffIsWhatItsClassSays() throws UnreadableFile {
    ImportedProgram program =
        read(
            main(
                """
                <SuppressedNode><suppressedNode class="Folder" name="a"><children><Halt/></children>
                </suppressedNode></SuppressedNode>
                <SuppressedNode><suppressedNode class="Comment" comment="b" colour="c"/></SuppressedNode>
                """));
    List<ProgramNode> nodes = program.tree().sections().getFirst().children();
    assertEquals(
        List.of(new ActionStep.Folder("a"), new ActionStep.Comment("b")),
        nodes.stream().map(ProgramNode::step).toList());
    assertEquals(List.of(true, true), nodes.stream().map(ProgramNode::suppressed).toList());
    assertEquals(new ActionStep.Halt(), nodes.getFirst().children().getFirst().step());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void anUnknownNodeThatIsSwitchedOffIsKeptWithoutARemark() throws UnreadableFile {
    String weld = "<suppressedNode class=\"Weld\" speed=\"1\"/>";
    ImportedProgram program = read(main("<SuppressedNode>" + weld + "</SuppressedNode>"));
    ProgramNode node = program.tree().sections().getFirst().children().getFirst();
    assertEquals(new ForeignStep.Unknown("Weld", List.of("<Weld speed=\"1\"/>")), node.step());
    assertTrue(node.suppressed());
    assertEquals(List.of(), program.remarks());
  }

  @Test
  void wholePartsOfAProgramCanBeSwitchedOff() throws UnreadableFile {
    ImportedProgram program =
        read(
            program(
                """
                <MainProgram><children>
                <CallSubProgram><subprogram name="S"><children><Halt/></children></subprogram>
                </CallSubProgram></children></MainProgram>
                <SuppressedNode><suppressedNode class="Thread" name="T" runOnlyOnce="true">
                <children><Halt/></children></suppressedNode></SuppressedNode>
                <SuppressedNode><suppressedNode class="SubProgram"
                 reference="../../MainProgram/children/CallSubProgram/subprogram"/></SuppressedNode>
                """));
    assertEquals(
        List.of(
            "MainProgram[forever=true] false",
            "ThreadSection[name=T, forever=false] true",
            "SubProgram[name=S, file=] true"),
        program.tree().sections().stream()
            .map(each -> each.step() + " " + each.suppressed())
            .toList());
    assertEquals(List.of(), program.remarks());
  }
}
