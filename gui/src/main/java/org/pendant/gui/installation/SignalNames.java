package org.pendant.gui.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.models.arm.ArmDescription;

/** Names and uses of signals in an installation. */
public final class SignalNames {
  private SignalNames() {}

  /**
   * An installation in which a signal has another name.
   *
   * @param signal such as {@code digital_in[0]}
   * @param name empty for none
   * @return empty if the name cannot be, such as that of another signal
   */
  public static Optional<Installation> rename(
      Installation installation, ArmDescription arm, String signal, String name) {
    SignalUse before = use(installation, signal);
    SignalUse after = new SignalUse(signal, name, before.input(), before.output());
    Installation next = installation.withSignals(with(installation.signals(), after));
    boolean wrong =
        InstallationCheck.problems(next, arm).stream()
            .anyMatch(each -> each.field().matches("signals\\[\\d+\\]\\.name"));
    return wrong ? Optional.empty() : Optional.of(next);
  }

  /** What a signal is called and does. */
  static SignalUse use(Installation installation, String signal) {
    return installation.signals().stream()
        .filter(each -> each.signal().equals(signal))
        .findFirst()
        .orElse(new SignalUse(signal, "", InputAction.DEFAULT, RunStateAction.PRESERVE));
  }

  /** The list with another use of one; one without name and use is not mentioned. */
  static List<SignalUse> with(List<SignalUse> signals, SignalUse after) {
    List<SignalUse> next = new ArrayList<>(signals);
    int at = -1;
    for (int i = 0; i < next.size(); i++) {
      at = next.get(i).signal().equals(after.signal()) ? i : at;
    }
    boolean plain =
        after.name().isEmpty()
            && after.input() == InputAction.DEFAULT
            && after.output() == RunStateAction.PRESERVE;
    if (at < 0 && !plain) {
      next.add(after);
    } else if (at >= 0 && plain) {
      next.remove(at);
    } else if (at >= 0) {
      next.set(at, after);
    }
    return next;
  }
}
