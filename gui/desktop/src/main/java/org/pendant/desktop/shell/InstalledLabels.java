package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import org.pendant.controller.installation.SignalUse;
import org.pendant.desktop.installation.SignalNames;
import org.pendant.desktop.io.SignalLabels;
import org.pendant.desktop.session.ActiveInstallation;

/** Installed labels: the names of signals in the installation, which people change there too. */
final class InstalledLabels {
  private InstalledLabels() {}

  /** Those of an installation, and of the settings where it has none. */
  static SignalLabels of(ShellWorkbench workbench, ActiveInstallation installation) {
    SignalLabels labels =
        SignalLabels.installed(
            workbench.settings(),
            signal ->
                installation.current().signals().stream()
                    .filter(each -> each.signal().equals(signal))
                    .map(SignalUse::name)
                    .findFirst()
                    .orElse(""),
            (signal, name) ->
                SignalNames.rename(
                        installation.current(), workbench.session().options().arm(), signal, name)
                    .ifPresentOrElse(
                        installation::set,
                        () -> workbench.notify(text("isTheNameOfAnotherSignal", name))));
    installation.addListener(labels::changed);
    return labels;
  }
}
