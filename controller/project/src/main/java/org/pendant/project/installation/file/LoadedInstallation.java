package org.pendant.project.installation.file;

import java.util.List;
import org.pendant.controller.installation.Installation;

/**
 * Loaded installation as it was read from a file.
 *
 * @param installation what it says
 * @param remarks what of it was not understood; none for files in our own form
 */
public record LoadedInstallation(Installation installation, List<String> remarks) {
  public LoadedInstallation {
    remarks = List.copyOf(remarks);
  }
}
