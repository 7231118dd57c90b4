package org.pendant.protocols.rtde;

import static org.pendant.protocols.rtde.RtdeTexts.text;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.function.Consumer;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.rtde.InputField;
import org.pendant.controller.rtde.InputFields;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.OutputField;
import org.pendant.controller.rtde.OutputFields;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SoftwareVersion;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;
import org.pendant.protocols.server.ServerContext;

/**
 * RTDE session: one client. Requests are answered in their order; nothing comes unasked before a
 * start.
 */
final class RtdeSession implements Session {
  private static final int NEWEST_VERSION = 2;
  private static final double MIN_HZ = 1;
  private static final String NOT_FOUND = "NOT_FOUND";
  private static final String IN_USE = "IN_USE";

  /** The number of a recipe that cannot be used. */
  private static final int UNUSABLE = 0;

  private final Connection connection;
  private final PeerLog log;
  private final PacketCutter cutter = new PacketCutter();
  private final DataFlow flow;
  private final InputHandler inputs;
  private final Runnable leave;
  private RtdeTerms terms = RtdeTerms.NONE;

  /**
   * A client that has just connected.
   *
   * @param inputRoom what all clients share, see {@link InputHandler}
   */
  RtdeSession(Connection connection, ServerContext serverContext, Semaphore inputRoom) {
    this.connection = connection;
    log = serverContext.log();
    flow = new DataFlow(connection::stream);
    inputs = new InputHandler(serverContext.robot(), connection.name(), inputRoom);
    Consumer<ControllerState> frames = flow::frame;
    serverContext.frames().add(frames);
    leave = () -> serverContext.frames().remove(frames);
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    try {
      for (Optional<Packet> packet = cutter.next(bytes);
          packet.isPresent();
          packet = cutter.next(bytes)) {
        answer(RequestCodec.decode(packet.get(), terms.version()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void closed() {
    leave.run();
    try {
      inputs.release();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void answer(RtdeRequest request) throws InterruptedException {
    switch (request) {
      case RtdeRequest.ProtocolVersion wanted -> speak(wanted.version());
      case RtdeRequest.ControllerVersion _ ->
          connection.send(ReplyCodec.controllerVersion(SoftwareVersion.REPORTED));
      case RtdeRequest.SetupOutputs wanted -> setUpOutputs(wanted);
      case RtdeRequest.SetupInputs wanted -> setUpInputs(wanted.names());
      case RtdeRequest.RefusedSetup wanted -> refuseSetup(wanted);
      case RtdeRequest.Start _ -> start();
      case RtdeRequest.Pause _ -> {
        flow.pause();
        agree(terms.withSending(false));
        connection.send(ReplyCodec.accepted(PacketType.PAUSE, true));
      }
      case RtdeRequest.Data data ->
          inputs.write(data).ifPresent(reason -> complain(TextLevel.ERROR, reason));
      case RtdeRequest.Text text ->
          log.write(text.level().logged(), text("clientSaid", connection.name(), text.text()));
      case RtdeRequest.Malformed wrong -> complain(wrong.level(), wrong.reason());
    }
  }

  private void agree(RtdeTerms now) {
    terms = now;
    connection.agree(now);
  }

  private void speak(int wanted) {
    boolean known = wanted >= 1 && wanted <= NEWEST_VERSION;
    if (known) {
      agree(terms.withVersion(wanted));
    }
    connection.send(ReplyCodec.accepted(PacketType.PROTOCOL_VERSION, known));
  }

  private void setUpOutputs(RtdeRequest.SetupOutputs wanted) {
    List<OutputField> fields = new ArrayList<>();
    List<String> types = new ArrayList<>();
    for (String name : wanted.names()) {
      Optional<OutputField> field = OutputFields.of(name);
      field.ifPresent(fields::add);
      types.add(field.map(each -> each.type().name()).orElse(NOT_FOUND));
    }
    boolean numbered = terms.version() > 1;
    int bytes = OutputRecipe.packetBytes(fields, numbered);
    boolean known = fields.size() == wanted.names().size() && Double.isFinite(wanted.frequencyHz());
    boolean usable = known && bytes <= Packet.MAX_BYTES;
    if (usable) {
      OutputRecipe recipe = new OutputRecipe(fields, numbered);
      double frequencyHz = Math.clamp(wanted.frequencyHz(), MIN_HZ, Pacing.FRAMES_HZ);
      flow.setUp(recipe, frequencyHz);
      agree(terms.withOutputsOf(fields, frequencyHz));
    } else {
      clear();
    }
    answerSetup(PacketType.SETUP_OUTPUTS, usable ? OutputRecipe.ID : UNUSABLE, types);
    if (known && !usable) {
      complain(TextLevel.ERROR, text("dataOfRecipeTooLong", bytes, Packet.MAX_BYTES));
    }
  }

  private void clear() {
    flow.clear();
    agree(terms.withOutputs(List.of(), 0));
  }

  private void refuseSetup(RtdeRequest.RefusedSetup wanted) {
    if (wanted.type() == PacketType.SETUP_OUTPUTS) {
      clear();
    }
    answerSetup(wanted.type(), UNUSABLE, List.of());
    complain(TextLevel.ERROR, wanted.reason());
  }

  /** Answers a recipe: clients wait for it. Types that one package cannot hold are left out. */
  private void answerSetup(int type, int id, List<String> types) {
    boolean numbered = terms.version() > 1 || type == PacketType.SETUP_INPUTS;
    byte[] answer = numbered ? ReplyCodec.recipe(type, id, types) : ReplyCodec.recipe(type, types);
    if (answer.length <= Packet.MAX_BYTES) {
      connection.send(answer);
    } else {
      refuseSetup(
          new RtdeRequest.RefusedSetup(
              type, text("typesOfRecipeTooLong", types.size(), answer.length, Packet.MAX_BYTES)));
    }
  }

  private void setUpInputs(List<String> names) throws InterruptedException {
    List<Optional<InputField>> fields = names.stream().map(InputFields::of).toList();
    InputRecipe recipe = new InputRecipe(fields.stream().flatMap(Optional::stream).toList());
    boolean known = recipe.fields().size() == names.size() && inputs.hasRoom();
    Set<String> inUse = known ? inputs.claim(recipe) : Set.of();
    List<String> types =
        fields.stream()
            .map(field -> field.map(each -> type(each, inUse)).orElse(NOT_FOUND))
            .toList();
    int id = known && inUse.isEmpty() ? inputs.add(recipe) : UNUSABLE;
    if (id != UNUSABLE) {
      agree(terms.withInputsOf(recipe));
    }
    answerSetup(PacketType.SETUP_INPUTS, id, types);
    if (!inputs.hasRoom() && id == UNUSABLE) {
      tell(TextLevel.ERROR, text("mostInputRecipes", InputHandler.MAX_RECIPES));
    }
  }

  private static String type(InputField field, Set<String> inUse) {
    return inUse.contains(field.name()) ? IN_USE : field.type().name();
  }

  private void start() {
    // the answer has to come before the first data
    connection.send(ReplyCodec.accepted(PacketType.START, flow.ready()));
    flow.start();
    agree(terms.withSending(flow.ready()));
  }

  /** Tells the client, and the log too: many clients pass texts over. */
  private void complain(TextLevel level, String reason) {
    log.write(Level.WARNING, connection.says(reason));
    tell(level, reason);
  }

  private void tell(TextLevel level, String text) {
    connection.send(ReplyCodec.text(level, text, terms.version()));
  }
}
