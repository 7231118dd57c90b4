package org.pendant.project.installation.text;

import java.util.List;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.text.TextProblem;

/**
 * Installation as it was read.
 *
 * @param installation what could be understood
 * @param problems what could not, in the order of the lines; the installation is the whole one only
 *     if there are none
 */
public record ReadInstallation(Installation installation, List<TextProblem> problems) {
  public ReadInstallation {
    problems = List.copyOf(problems);
  }
}
