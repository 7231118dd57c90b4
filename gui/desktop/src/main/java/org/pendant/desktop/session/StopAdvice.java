package org.pendant.desktop.session;

/** Stop advice: what may help against stops. */
public final class StopAdvice {
  private StopAdvice() {}

  /** What may help against a stop or warning with this code, the x of CxAy. */
  public static String of(int code) {
    return switch (code) {
      case 100 -> "Release the safety input; after an emergency stop switch the arm on again.";
      case 150 -> "Move the joint's target away from the end of its range.";
      case 151 -> "Choose a pose in which the tool is tilted less.";
      case 152 -> "Choose a path that stays clear of the safety plane.";
      case 153, 173 ->
          "The arm could not follow: check payload and centre of gravity, or lower the"
              + " acceleration.";
      case 154 -> "Choose a path that stays clear of the singularity, or a joint move past it.";
      case 155 ->
          "Declare what hangs on the flange with set_target_payload, and let go of the tool until"
              + " freedrive has begun.";
      case 157 ->
          "Something was hit, or the declared payload is wrong: look at the path and at"
              + " set_target_payload.";
      case 191 -> "A safety limit was exceeded: lower speed or force, or change the limits.";
      case 192 -> "A sensor reports no number: restart the safety functions.";
      case 200 -> "Choose a goal that the arm reaches.";
      case 204 -> "The target jumps: check servoj, speedj and the poses that the program computes.";
      case 209 -> "The program asked for this stop.";
      default -> "Look at the log for what happened before.";
    };
  }
}
