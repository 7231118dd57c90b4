package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** EtherNet/IP page: what the loss of an EtherNet/IP scanner does. */
final class EthernetIpPage implements Page {
  private final Editing editing;
  private final TitledCard card = new TitledCard("ethernet-ip", "EtherNet/IP", "[grow, fill]");
  private final PartsForm<Installation> form;

  EthernetIpPage(Editing editing) {
    this.editing = editing;
    form = new PartsForm<>("ethernet-ip", editing::whole, editing::takeWhole);
    form.check(
            "on",
            text("on"),
            now -> now.ethernetIpLoss().isPresent(),
            (before, on) -> with(before, on ? Optional.of(WatchdogAction.PAUSE) : Optional.empty()))
        .<WatchdogAction>choice(
            "when-a-scanner-is-lost",
            text("whenAScannerIsLost"),
            now -> List.of(WatchdogAction.values()),
            action ->
                switch (action) {
                  case IGNORE -> text("continue");
                  case PAUSE -> text("pauseTheProgram");
                  case STOP -> text("stopTheProgram");
                },
            now -> now.ethernetIpLoss().orElse(WatchdogAction.IGNORE),
            (before, action) -> with(before, Optional.of(action)))
        .note(text("theAdapterItselfIsReachedWhile"));
    card.add(form.component());
  }

  private static Installation with(Installation before, Optional<WatchdogAction> loss) {
    return before.with(parts -> parts.ethernetIpLoss = loss);
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
