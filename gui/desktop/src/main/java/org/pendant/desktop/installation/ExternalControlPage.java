package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import javax.swing.JComponent;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** External Control page: where the nodes get their script. */
final class ExternalControlPage implements Page {
  private final Editing editing;
  private final TitledCard card =
      new TitledCard("external-control", "External Control", "[grow, fill]");
  private final PartsForm<Installation> form;

  ExternalControlPage(Editing editing) {
    this.editing = editing;
    form = new PartsForm<>("external-control", editing::whole, editing::takeWhole);
    form.text(
            "host",
            text("host"),
            now -> now.controlHost().host(),
            (before, host) -> with(before, new ControlHost(host.strip(), port(before))))
        .text(
            "port",
            text("port"),
            now -> String.valueOf(port(now)),
            (before, port) ->
                with(before, new ControlHost(before.controlHost().host(), read(port))))
        .note(text("theComputerWhoseDriverSendsThe"));
    card.add(form.component());
  }

  private static int port(Installation installation) {
    return installation.controlHost().port();
  }

  private static int read(String port) {
    try {
      return Integer.parseInt(port.strip());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(text("expectedANumberSuchAs50002"), e);
    }
  }

  private static Installation with(Installation before, ControlHost host) {
    return before.with(parts -> parts.controlHost = host);
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    form.show(editing.now());
  }
}
