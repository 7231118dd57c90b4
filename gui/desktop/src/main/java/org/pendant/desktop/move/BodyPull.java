package org.pendant.desktop.move;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.world.Vector3;

/**
 * Body pull: the hand that carries an object with a mass in a picture of it. One thread uses it.
 */
public final class BodyPull {
  private final RepeatedCommand carry;
  private Optional<Held> held = Optional.empty();
  private Optional<String> reason = Optional.empty();

  private record Held(String object, Vector3 pointInBaseM) {
    Command to(Vector3 placeInBaseM) {
      return new WorldCommand.CarryObject(object, pointInBaseM, placeInBaseM);
    }
  }

  /**
   * Nothing is held.
   *
   * @param submit hands commands to the controller
   * @param executor runs what replies lead to in the thread that uses this object
   */
  public BodyPull(Function<Command, CompletableFuture<Reply>> submit, Executor executor) {
    carry = new RepeatedCommand(submit, executor, new WorldCommand.LetGo());
  }

  /** An object is taken at a point. */
  public void begin(String object, Vector3 pointInBaseM) {
    end();
    Held now = new Held(object, pointInBaseM);
    held = Optional.of(now);
    carry.begin(now.to(pointInBaseM));
  }

  /** It is carried to another place. */
  public void move(Vector3 placeInBaseM) {
    held.ifPresent(now -> carry.change(now.to(placeInBaseM)));
  }

  /** Repeats what is held; about 30 times a second. */
  public void repeat() {
    if (carry.refused()) {
      reason = Optional.of(carry.reason());
      end();
    }
    carry.repeat();
  }

  /** It is let go. */
  public void end() {
    held = Optional.empty();
    carry.release();
  }

  /** Why it was not carried; told once, then empty. */
  public Optional<String> newReason() {
    Optional<String> told = reason;
    reason = Optional.empty();
    return told;
  }
}
