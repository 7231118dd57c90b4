package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import org.pendant.controller.rtde.FieldType;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** RTDE dissector: follows what a client sets up, so that values can be read by their names. */
final class RtdeDissector implements Dissector {
  private static final String NAMES = "names";
  private static final String ACCEPTED = "accepted";
  private static final String RECIPE = "recipe";

  private RtdeTerms terms;

  /** The recipes that wait for their answers, in the order of the requests. */
  private final Queue<RtdeRequest.SetupOutputs> wantedOutputs = new ArrayDeque<>();

  private final Queue<RtdeRequest.SetupInputs> wantedInputs = new ArrayDeque<>();
  private int wantedVersion = 1;

  /** The last package of each input recipe. */
  private final Map<Integer, Map<String, Object>> written = new HashMap<>();

  /** Goes on from {@code terms}. */
  RtdeDissector(RtdeTerms terms) {
    this.terms = terms;
  }

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    if (bytes.remaining() < Short.BYTES) {
      return MORE;
    }
    int size = Short.toUnsignedInt(bytes.getShort(bytes.position()));
    return size < Packet.HEADER_BYTES ? UNKNOWN : size;
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    int type = Byte.toUnsignedInt(message.get(Packet.HEADER_BYTES - 1));
    ByteBuffer payload = message.position(Packet.HEADER_BYTES).slice();
    return direction == Direction.IN ? request(new Packet(type, payload)) : answer(type, payload);
  }

  private Reading request(Packet packet) {
    return switch (RequestCodec.decode(packet, terms.version())) {
      case RtdeRequest.ProtocolVersion wanted -> {
        wantedVersion = wanted.version();
        yield Reading.of(
            "protocol-version",
            RtdeTexts.text("protocolVersion", wanted.version()),
            () -> Fields.of("version", wanted.version()));
      }
      case RtdeRequest.ControllerVersion _ ->
          Reading.of("controller-version", RtdeTexts.text("asksForControllerVersion"));
      case RtdeRequest.SetupOutputs wanted -> {
        wantedOutputs.add(wanted);
        yield Reading.of(
            "setup-outputs",
            RtdeTexts.text(
                "wantsAtRate", hertz(wanted.frequencyHz()), Reading.names(wanted.names())),
            () -> Fields.of("frequency_hz", wanted.frequencyHz(), NAMES, wanted.names()));
      }
      case RtdeRequest.SetupInputs wanted -> {
        wantedInputs.add(wanted);
        yield Reading.of(
            "setup-inputs",
            RtdeTexts.text("wantsToWrite", Reading.names(wanted.names())),
            () -> Fields.of(NAMES, wanted.names()));
      }
      case RtdeRequest.RefusedSetup refused ->
          Reading.of(
              refused.type() == PacketType.SETUP_OUTPUTS ? "setup-outputs" : "setup-inputs",
              refused.reason());
      case RtdeRequest.Start _ -> Reading.of("start", RtdeTexts.text("asksForData"));
      case RtdeRequest.Pause _ -> Reading.of("pause", RtdeTexts.text("asksForNoMoreData"));
      case RtdeRequest.Data data -> inputs(data);
      case RtdeRequest.Text text -> text(text.level(), text.text());
      case RtdeRequest.Malformed wrong -> Reading.of("malformed", wrong.reason());
    };
  }

  private Reading text(TextLevel level, String text) {
    return Reading.of(
        "text",
        RtdeTexts.text("says", text),
        () -> Fields.of("level", level.number(), "text", text));
  }

  private static String hertz(double frequencyHz) {
    return frequencyHz == Math.rint(frequencyHz) ? (long) frequencyHz + " Hz" : frequencyHz + " Hz";
  }

  private Reading inputs(RtdeRequest.Data data) {
    int number = data.recipe();
    if (number < 1 || number > terms.inputs().size()) {
      return Reading.of("data", RtdeTexts.text("valuesOfUnknownInputRecipe", number));
    }
    Map<String, Object> values = values(terms.inputs().get(number - 1), data.values());
    Map<String, Object> before = written.getOrDefault(number, Map.of());
    written.put(number, values);
    List<String> changed = new ArrayList<>();
    values.forEach(
        (name, value) -> {
          if (!value.equals(before.get(name))) {
            changed.add(name + " = " + value);
          }
        });
    Reading reading =
        Reading.of(
            "data",
            RtdeTexts.text("inputRecipe", number, shown(values)),
            () -> Fields.of(RECIPE, number, "values", values));
    return changed.isEmpty()
        ? reading
        : reading.doing(RtdeTexts.text("sets", Reading.names(changed)));
  }

  private static String shown(Map<String, Object> values) {
    List<String> texts = new ArrayList<>();
    values.forEach((name, value) -> texts.add(name + " = " + value));
    return Reading.names(texts);
  }

  private static Map<String, Object> values(List<ReceivedField> fields, ByteBuffer data) {
    Map<String, Object> values = new LinkedHashMap<>();
    for (ReceivedField field : fields) {
      values.put(field.name(), value(field, data));
    }
    return values;
  }

  private static Object value(ReceivedField field, ByteBuffer data) {
    double[] numbers = new double[field.count()];
    field.read(data, numbers, 0);
    return switch (field.type()) {
      case BOOL -> numbers[0] != 0;
      case UINT8, UINT32, UINT64, INT32 -> (long) numbers[0];
      case DOUBLE -> numbers[0];
      case VECTOR3D, VECTOR6D -> Arrays.stream(numbers).boxed().toList();
      case VECTOR6INT32, VECTOR6UINT32 ->
          Arrays.stream(numbers).mapToObj(each -> (long) each).toList();
    };
  }

  private Reading answer(int type, ByteBuffer payload) {
    return switch (type) {
      case PacketType.PROTOCOL_VERSION -> {
        boolean accepted = payload.get() != 0;
        terms = accepted ? terms.withVersion(wantedVersion) : terms;
        yield accepted(
            "protocol-version", RtdeTexts.text("protocolVersion", wantedVersion), accepted);
      }
      case PacketType.CONTROLLER_VERSION -> {
        List<Integer> parts =
            List.of(payload.getInt(), payload.getInt(), payload.getInt(), payload.getInt());
        String version = String.join(".", parts.stream().map(String::valueOf).toList());
        yield Reading.of(
            "controller-version",
            RtdeTexts.text("version", version),
            () -> Fields.of("version", version));
      }
      case PacketType.SETUP_OUTPUTS -> outputsAnswer(payload);
      case PacketType.SETUP_INPUTS -> inputsAnswer(payload);
      case PacketType.START -> {
        boolean accepted = payload.get() != 0;
        terms = terms.withSending(accepted);
        yield accepted("start", RtdeTexts.text("dataBegins"), accepted);
      }
      case PacketType.PAUSE -> {
        terms = terms.withSending(false);
        yield accepted("pause", RtdeTexts.text("dataEnds"), payload.get() != 0);
      }
      case PacketType.DATA -> outputs(payload);
      case PacketType.TEXT_MESSAGE -> textAnswer(payload);
      default -> Reading.of("unknown", RtdeTexts.text("packageType", type));
    };
  }

  /** A text as {@link ReplyCodec} writes it. */
  private Reading textAnswer(ByteBuffer payload) {
    if (terms.version() == 1) {
      return text(TextLevel.of(payload.get()), Dissector.text(payload));
    }
    String said = shortText(payload);
    String by = shortText(payload);
    return text(TextLevel.of(payload.get()), by + ": " + said);
  }

  private static String shortText(ByteBuffer payload) {
    int length = Byte.toUnsignedInt(payload.get());
    String text = Dissector.text(payload.slice(payload.position(), length));
    payload.position(payload.position() + length);
    return text;
  }

  private static Reading accepted(String type, String what, boolean accepted) {
    return Reading.of(
        type,
        accepted ? what : RtdeTexts.text("refused", what),
        () -> Fields.of(ACCEPTED, accepted));
  }

  private Reading outputsAnswer(ByteBuffer payload) {
    RtdeRequest.SetupOutputs wanted = wantedOutputs.poll();
    int recipe = terms.version() == 1 ? OutputRecipe.ID : Byte.toUnsignedInt(payload.get());
    List<String> types = types(payload);
    Optional<List<ReceivedField>> fields =
        wanted == null || recipe == 0 ? Optional.empty() : fields(wanted.names(), types);
    terms = terms.withOutputs(fields.orElse(List.of()), wanted == null ? 0 : wanted.frequencyHz());
    return setup("setup-outputs", recipe, types, wanted == null ? List.of() : wanted.names());
  }

  private Reading inputsAnswer(ByteBuffer payload) {
    RtdeRequest.SetupInputs wanted = wantedInputs.poll();
    int recipe = Byte.toUnsignedInt(payload.get());
    List<String> types = types(payload);
    if (wanted != null && recipe > 0) {
      fields(wanted.names(), types).ifPresent(fields -> terms = terms.withInputs(fields));
    }
    return setup("setup-inputs", recipe, types, wanted == null ? List.of() : wanted.names());
  }

  private static Reading setup(String type, int recipe, List<String> types, List<String> names) {
    List<String> refused = new ArrayList<>();
    for (int i = 0; i < Math.min(types.size(), names.size()); i++) {
      if (type(types.get(i)).isEmpty()) {
        refused.add(names.get(i) + " is " + types.get(i));
      }
    }
    return Reading.of(
        type,
        recipe == 0
            ? RtdeTexts.text("refused", Reading.names(refused))
            : RtdeTexts.text("recipe", recipe, Reading.names(types)),
        () -> Fields.of(RECIPE, recipe, "types", types));
  }

  private static List<String> types(ByteBuffer payload) {
    String text = Dissector.text(payload);
    return text.isEmpty() ? List.of() : List.of(text.split(",", -1));
  }

  private static Optional<List<ReceivedField>> fields(List<String> names, List<String> types) {
    List<ReceivedField> fields = new ArrayList<>();
    for (int i = 0; i < Math.min(names.size(), types.size()); i++) {
      String name = names.get(i);
      type(types.get(i)).ifPresent(each -> fields.add(new ReceivedField(name, each)));
    }
    return fields.size() == names.size() ? Optional.of(fields) : Optional.empty();
  }

  private static Optional<FieldType> type(String name) {
    return Arrays.stream(FieldType.values()).filter(each -> each.name().equals(name)).findFirst();
  }

  private Reading outputs(ByteBuffer payload) {
    int recipe = terms.version() == 1 ? OutputRecipe.ID : Byte.toUnsignedInt(payload.get());
    List<ReceivedField> fields = terms.outputs();
    ByteBuffer values = payload.slice();
    if (fields.isEmpty()) {
      return Reading.of("data", RtdeTexts.text("valuesOfUnknownRecipe", recipe));
    }
    ReceivedField first = fields.getFirst();
    String shown = first.name() + " = " + value(first, values.duplicate());
    return Reading.of(
        "data",
        fields.size() > 1 ? RtdeTexts.text("valueAndMore", shown, fields.size() - 1) : shown,
        () -> Fields.of(RECIPE, recipe, "values", values(fields, values.duplicate())));
  }
}
