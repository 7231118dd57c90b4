package org.pendant.protocols.rtde;

import static org.pendant.protocols.rtde.RtdeTexts.text;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.Deadline;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.rtde.RtdeCommand;

/**
 * Input handler: the RTDE inputs that one client writes. For the client's own thread, which may
 * wait.
 */
final class InputHandler {
  /** Their numbers have one byte, and 0 is none. */
  static final int MAX_RECIPES = 255;

  /** A client that writes more than so many packages a frame waits for the frame. */
  private static final int MAX_IN_A_FRAME = 8;

  /** What all clients together have waiting, so that others find places for their commands. */
  static final int MAX_OF_ALL = 512;

  /**
   * So long after a client has closed its connection another one may still find its inputs taken.
   */
  private static final Duration LEAVING = Duration.ofMillis(250);

  /** When to ask again meanwhile, ms. */
  private static final long AGAIN_MS = 4;

  /** A frame takes 2 ms: who gets no answer for this long speaks to a box that has stopped. */
  private static final Duration PATIENCE = Duration.ofSeconds(5);

  private final Robot robot;
  private final String client;
  private final List<InputRecipe> recipes = new ArrayList<>();
  private final long openedNs = System.nanoTime();
  private final Semaphore roomOfAll;
  private final Semaphore room = new Semaphore(MAX_IN_A_FRAME);

  /** What was wrong with the last package of each recipe. */
  private final Map<Integer, String> complaints = new HashMap<>();

  /**
   * Nothing yet.
   *
   * @param roomOfAll what all clients share, {@link #MAX_OF_ALL} at first
   */
  InputHandler(Robot robot, String client, Semaphore roomOfAll) {
    this.robot = robot;
    this.client = client;
    this.roomOfAll = roomOfAll;
  }

  /** Whether there may be another recipe. */
  boolean hasRoom() {
    return recipes.size() < MAX_RECIPES;
  }

  /** Keeps a recipe whose inputs are {@link #claim claimed}; answers its number, from 1. */
  int add(InputRecipe recipe) {
    recipes.add(recipe);
    return recipes.size();
  }

  /**
   * Takes all inputs of a recipe, unless another client has some of them, which are answered. They
   * may be those of a client that had gone before this one came, but whose end is noticed only a
   * moment later: this waits that long.
   */
  Set<String> claim(InputRecipe recipe) throws InterruptedException {
    Set<String> inUse = claimNow(recipe);
    while (!inUse.isEmpty() && System.nanoTime() - openedNs < LEAVING.toNanos()) {
      TimeUnit.MILLISECONDS.sleep(AGAIN_MS);
      inUse = claimNow(recipe);
    }
    return inUse;
  }

  private Set<String> claimNow(InputRecipe recipe) throws InterruptedException {
    CompletableFuture<Set<String>> inUse = new CompletableFuture<>();
    Reply reply =
        robot.ask(
            new RtdeCommand.ClaimInputs(client, recipe, inUse::complete),
            Deadline.orNever(PATIENCE));
    // a box that does not answer gives nothing away, now or later
    return reply instanceof Reply.Done ? inUse.getNow(recipe.names()) : recipe.names();
  }

  /**
   * Writes a package in the next frame.
   *
   * @return what there is to complain about, unless the package before had the same mistake
   */
  Optional<String> write(RtdeRequest.Data data) throws InterruptedException {
    List<String> mistakes = tryToWrite(data);
    if (mistakes.isEmpty()) {
      complaints.remove(data.recipe());
      return Optional.empty();
    }
    String complaint = String.join("; ", mistakes);
    return complaint.equals(complaints.put(data.recipe(), complaint))
        ? Optional.empty()
        : Optional.of(complaint);
  }

  private List<String> tryToWrite(RtdeRequest.Data data) throws InterruptedException {
    int number = data.recipe();
    if (number < 1 || number > recipes.size()) {
      return List.of(text("noInputRecipe", number));
    }
    InputRecipe recipe = recipes.get(number - 1);
    if (data.values().remaining() != recipe.bytes()) {
      return List.of(
          text("inputValuesOfWrongLength", number, data.values().remaining(), recipe.bytes()));
    }
    InputUpdate update = recipe.decode(data.values());
    return submit(update) ? update.ignored() : List.of(text("inputsNotWritten"));
  }

  private boolean submit(InputUpdate update) throws InterruptedException {
    if (!taken(room)) {
      return false;
    }
    if (!taken(roomOfAll)) {
      room.release();
      return false;
    }
    var _ =
        robot
            .submit(new RtdeCommand.WriteInputs(client, update))
            .whenComplete(
                (answer, failure) -> {
                  room.release();
                  roomOfAll.release();
                });
    return true;
  }

  private static boolean taken(Semaphore place) throws InterruptedException {
    return place.tryAcquire(PATIENCE.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** Gives all inputs back; their values stay. */
  void release() throws InterruptedException {
    var _ = robot.ask(new IoCommand.ReleaseSignals(client), Deadline.orLater(PATIENCE));
  }
}
