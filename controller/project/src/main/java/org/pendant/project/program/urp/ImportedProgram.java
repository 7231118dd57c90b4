package org.pendant.project.program.urp;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.NamedTool;
import org.pendant.project.program.ProgramTree;

/**
 * Imported program as it was read from a file of PolyScope.
 *
 * @param name of the program, as the file says
 * @param tree all that is in it
 * @param features that its waypoints refer to, where they were when these were taught
 * @param tools TCPs that its moves name, as they were when the waypoints of these were taught
 * @param robot id of the arm that it was made on, if the file describes one that is known
 * @param remarks what was not understood or is kept as it was, each with its line
 */
public record ImportedProgram(
    String name,
    ProgramTree tree,
    List<Feature> features,
    List<NamedTool> tools,
    Optional<String> robot,
    List<String> remarks) {
  public ImportedProgram {
    features = List.copyOf(features);
    tools = List.copyOf(tools);
    remarks = List.copyOf(remarks);
  }
}
