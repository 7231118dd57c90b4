package org.pendant.desktop.program;

import java.util.List;
import org.pendant.project.program.ForeignStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.urp.ShownNodes;

/**
 * Foreign tree: a program of PolyScope X as people see it. In the file its nodes are suppressed
 * folders, as the script beside them runs; here they are foreign nodes, with the lines that do
 * their work.
 */
final class ForeignTree {
  private ForeignTree() {}

  /** A tree that was read from such a file; all nodes keep their keys. */
  static ProgramTree shown(ProgramTree written) {
    List<ProgramNode> sections =
        written.sections().stream()
            .map(
                section ->
                    section.withChildren(
                        section.children().stream()
                            .map(
                                each ->
                                    ShownNodes.isShown(written, each.key()) ? shown(each) : each)
                            .toList()))
            .toList();
    return new ProgramTree(
        written.installation(), written.waypoints(), sections, written.nextKey());
  }

  private static ProgramNode shown(ProgramNode node) {
    List<ProgramNode> children = node.children().stream().map(ForeignTree::shown).toList();
    ProgramNode used = node.withSuppressed(false).withChildren(children);
    return children.isEmpty()
        ? used.withStep(
            new ForeignStep.Contributed("", StepNames.label(node), List.of(), List.of()))
        : used;
  }
}
