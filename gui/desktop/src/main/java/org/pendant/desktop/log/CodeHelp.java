package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.desktop.session.StopAdvice;

/**
 * Code help: what a code of the safety functions means, and what may help; docs/safety.md has the
 * same table.
 *
 * @param meaning a sentence
 * @param suggestion a sentence
 */
record CodeHelp(String meaning, String suggestion) {
  private static final Pattern CODE = Pattern.compile("C(\\d{1,4})A(\\d{1,4})");

  /** Help for a code such as {@code C153A2}; empty for others. */
  static Optional<CodeHelp> of(String code) {
    Matcher parts = CODE.matcher(code);
    if (!parts.matches()) {
      return Optional.empty();
    }
    int number = Integer.parseInt(parts.group(1));
    return meaning(number, Integer.parseInt(parts.group(2)))
        .map(meaning -> new CodeHelp(meaning, StopAdvice.of(number)));
  }

  private static Optional<String> meaning(int code, int argument) {
    return switch (code) {
      case 100 -> Optional.of(text("anInputDemandsAnEmergencyStop"));
      case 150 -> Optional.of(text("theTargetOfAJointCould"));
      case 151 -> Optional.of(text("hardlyStopBeforeTilt"));
      case 152 -> Optional.of(text("hardlyStopBeforePlane"));
      case 153 -> Optional.of(text("aJointWasAwayFromIts"));
      case 154 -> Optional.of(text("thePathLedThroughASingularity"));
      case 155 -> Optional.of(text("freedriveFoundAnotherPayloadOnThe"));
      case 157 -> Optional.of(text("aJointWasPushedFromOutside"));
      case 173 -> Optional.of(text("warningOnlyAJointIsAway"));
      case 191 -> Optional.of(text("aSafetyLimitWasExceeded", limit(argument)));
      case 192 -> Optional.of(text("aJointReportsNoNumberSo"));
      case 200 -> Optional.of(text("noJointPositionsReachAPoint"));
      case 204 ->
          Optional.of(argument == 3 ? text("theTargetSpeedJumps") : text("theTargetPositionJumps"));
      case 209 -> Optional.of(text("theProgramCalledProtectiveStop"));
      default -> Optional.empty();
    };
  }

  private static String limit(int argument) {
    return switch (argument) {
      case 0 -> text("jointPosition");
      case 1 -> text("jointSpeed");
      case 2 -> text("toolSpeed");
      case 3 -> text("elbowSpeed");
      case 4 -> "momentum";
      case 5 -> "power";
      case 6 -> text("toolForce");
      case 7 -> text("elbowForce");
      case 8 -> text("aSafetyPlane");
      case 9 -> text("directionOfTheTool");
      default -> text("oneThatIsNotKnownHere");
    };
  }
}
