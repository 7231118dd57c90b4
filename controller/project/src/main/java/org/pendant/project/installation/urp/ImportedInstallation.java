package org.pendant.project.installation.urp;

import java.util.List;
import org.pendant.controller.installation.Installation;

/**
 * Imported installation as it was read from a file of PolyScope.
 *
 * @param installation what was understood; the rest is as in a new one
 * @param remarks what was not understood
 * @param calibrated whether the file describes the arm that it was made on
 */
public record ImportedInstallation(
    Installation installation, List<String> remarks, boolean calibrated) {
  public ImportedInstallation {
    remarks = List.copyOf(remarks);
  }
}
