package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.signature.Type;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Form of a script value: its kind, then its content. Lists are written without spare room. */
final class ValueForm extends Form<Value> {
  static final ValueForm ANY = new ValueForm();

  private ValueForm() {}

  @Override
  void write(Value value, ByteSink out) {
    out.constant(value.kind());
    switch (value) {
      case NoneValue none -> {
        // its kind says all
      }
      case BoolValue bool -> out.bool(bool.value());
      case IntValue number -> out.whole(number.value());
      case FloatValue number -> out.number(number.value());
      case StringValue string -> out.text(string.bytes());
      case PoseValue pose -> ArmForms.POSE.write(pose.pose(), out);
      case NumberList list -> {
        out.constant(list.elementKind());
        out.count(list.length());
        for (int i = 0; i < list.length(); i++) {
          out.number(list.numberAt(i));
        }
      }
      case ObjectList list -> {
        out.constant(list.elementKind());
        write(list.sample(), out);
        out.count(list.length());
        for (int i = 0; i < list.length(); i++) {
          write(list.objectAt(i), out);
        }
      }
      case MatrixValue matrix -> {
        out.bool(matrix.integers());
        out.count(matrix.rows());
        out.count(matrix.columns());
        for (int i = 0; i < matrix.rows() * matrix.columns(); i++) {
          out.number(matrix.numberAt(i));
        }
      }
      case StructValue struct -> {
        out.count(struct.length());
        for (int i = 0; i < struct.length(); i++) {
          out.text(struct.names().get(i));
          write(struct.memberAt(i), out);
        }
      }
      case HandleValue handle -> {
        out.constant(handle.type());
        out.whole(handle.id());
        out.text(handle.path());
      }
    }
  }

  @Override
  Value read(ByteSource in) throws MalformedBytes {
    in.deeper();
    Value value =
        switch (in.constant(ValueKind.class)) {
          case NONE -> NoneValue.NONE;
          case BOOL -> Value.of(in.bool());
          case INT -> Value.of(in.integer());
          case FLOAT -> Value.of(in.number());
          case STRING -> Value.of(in.text());
          case POSE -> new PoseValue(ArmForms.POSE.read(in));
          case LIST -> list(in);
          case MATRIX -> matrix(in);
          case STRUCT -> struct(in);
          case HANDLE -> new HandleValue(in.constant(Type.class), in.integer(), in.text());
        };
    in.shallower();
    return value;
  }

  private Value list(ByteSource in) throws MalformedBytes {
    ValueKind kind = in.constant(ValueKind.class);
    return kind.isNumber() || kind == ValueKind.BOOL ? numbers(kind, in) : objects(kind, in);
  }

  private static NumberList numbers(ValueKind kind, ByteSource in) throws MalformedBytes {
    double[] numbers = new double[in.count(Double.BYTES)];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = in.number();
    }
    return NumberList.owning(numbers, numbers.length, kind);
  }

  private ObjectList objects(ValueKind kind, ByteSource in) throws MalformedBytes {
    Value sample = checked(kind, read(in));
    int count = in.count(1);
    List<Value> elements = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      elements.add(checked(kind, read(in)));
    }
    return ObjectList.owning(elements.toArray(Value[]::new), count, sample);
  }

  private static Value checked(ValueKind wanted, Value element) throws MalformedBytes {
    if (element.kind() != wanted) {
      throw new MalformedBytes(text("elementKind", element.kind().described(), wanted.described()));
    }
    return element;
  }

  private static MatrixValue matrix(ByteSource in) throws MalformedBytes {
    boolean integers = in.bool();
    int rows = in.count(1);
    int columns = in.count(1);
    if ((long) rows * columns > in.left() / Double.BYTES) {
      throw new MalformedBytes(text("matrixAnnounced", rows, columns, in.left()));
    }
    double[] numbers = new double[rows * columns];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = in.number();
    }
    return MatrixValue.owning(rows, columns, numbers, integers);
  }

  private StructValue struct(ByteSource in) throws MalformedBytes {
    int count = in.count(2);
    List<String> names = new ArrayList<>();
    List<Value> members = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      names.add(in.text());
      members.add(read(in));
    }
    return StructValue.owning(names, members.toArray(Value[]::new));
  }
}
