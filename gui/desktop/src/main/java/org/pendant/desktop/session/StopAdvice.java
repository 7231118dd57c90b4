package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

/** Stop advice: what may help against stops. */
public final class StopAdvice {
  private StopAdvice() {}

  /** What may help against a stop or warning with this code, the x of CxAy. */
  public static String of(int code) {
    return switch (code) {
      case 100 -> text("adviceRelease");
      case 150 -> text("moveTheJointsTargetAwayFrom");
      case 151 -> text("chooseAPoseInWhichThe");
      case 152 -> text("clearOfPlane");
      case 153, 173 -> text("theArmCouldNotFollowCheck");
      case 154 -> text("clearOfSingularity");
      case 155 -> text("declareWhatHangsOnTheFlange");
      case 157 -> text("somethingWasHitOrTheDeclared");
      case 191 -> text("aSafetyLimitWasExceededLower");
      case 192 -> text("aSensorReportsNoNumberRestart");
      case 200 -> text("chooseAGoalThatTheArm");
      case 204 -> text("theTargetJumpsCheckServojSpeedj");
      case 209 -> text("unlockAndGoOn");
      default -> text("lookAtTheLogForWhat");
    };
  }
}
