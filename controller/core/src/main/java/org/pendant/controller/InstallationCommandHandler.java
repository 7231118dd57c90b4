package org.pendant.controller;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;

/** Handler of the commands about the installation. */
final class InstallationCommandHandler implements CommandHandler<InstallationCommand> {
  private final ControlBox box;
  private final ManualControl hand;
  private final InstallationHandler installed;

  InstallationCommandHandler(ControlBox box, ManualControl hand, InstallationHandler installed) {
    this.box = box;
    this.hand = hand;
    this.installed = installed;
  }

  @Override
  public Class<InstallationCommand> family() {
    return InstallationCommand.class;
  }

  @Override
  public Reply carryOut(InstallationCommand command) {
    return switch (command) {
      case InstallationCommand.ApplyInstallation(Installation installation) ->
          Reply.unless(apply(installation));
      case InstallationCommand.ScannerLost(String who) -> {
        installed.scannerLost(who);
        yield Reply.done();
      }
    };
  }

  private Optional<Refusal> apply(Installation next) {
    Optional<Refusal> refusal = hand.settingRefusal("installationIsChanged");
    if (refusal.isEmpty()) {
      refusal =
          InstallationCheck.refusal(next, box.arm().description())
              .map(problem -> new Refusal(Refusal.Code.INVALID, problem.toString()));
    }
    if (refusal.isEmpty()) {
      installed.change(next);
    }
    return refusal;
  }
}
