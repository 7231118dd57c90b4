package org.pendant.desktop.installation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.models.arm.ArmDescription;

/** Signal names and uses in an installation. */
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
    SignalUse was = use(installation, signal);
    SignalUse after = new SignalUse(signal, name, was.input(), was.output());
    Installation next = installation.withSignals(with(installation.signals(), after));
    Set<String> before = problems(installation, arm);
    return before.containsAll(problems(next, arm)) ? Optional.of(next) : Optional.empty();
  }

  /** What is wrong with names. */
  private static Set<String> problems(Installation installation, ArmDescription arm) {
    return InstallationCheck.problems(installation, arm).stream()
        .filter(SignalNames::isName)
        .map(InstallationProblem::message)
        .collect(Collectors.toSet());
  }

  /**
   * Whether a problem is about the name of a signal. People may not give one twice; installations
   * of robots may bring it along.
   */
  static boolean isName(InstallationProblem problem) {
    return problem.field().matches("signals\\[\\d+\\]\\.name");
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
