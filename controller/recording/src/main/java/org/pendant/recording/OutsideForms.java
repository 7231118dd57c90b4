package org.pendant.recording;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.modbus.ModbusSignalState;

/** Forms of what is exchanged with devices outside. */
final class OutsideForms {
  private static final Form<ModbusExchange> EXCHANGE =
      new Form<>() {
        @Override
        void write(ModbusExchange value, ByteSink out) {
          out.text(value.device().host());
          out.whole(value.device().port());
          out.whole(value.unit());
          out.constant(value.kind());
          out.whole(value.readAddress());
          out.whole(value.readCount());
          out.whole(value.writeAddress());
          out.whole(value.writeCount());
          out.bool(value.sequential());
        }

        @Override
        ModbusExchange read(ByteSource in) throws MalformedBytes {
          return new ModbusExchange(
              new ModbusAddress(in.text(), in.integer()),
              in.integer(),
              in.constant(ModbusKind.class),
              in.integer(),
              in.integer(),
              in.integer(),
              in.integer(),
              in.bool());
        }
      };

  private static final Form<List<Integer>> WHOLE_NUMBERS =
      new Form<Integer>() {
        @Override
        void write(Integer value, ByteSink out) {
          out.whole(value);
        }

        @Override
        Integer read(ByteSource in) throws MalformedBytes {
          return in.integer();
        }
      }.list();

  static final Form<List<ModbusSignalState>> MODBUS =
      new Form<ModbusSignalState>() {
        @Override
        void write(ModbusSignalState value, ByteSink out) {
          out.text(value.name());
          EXCHANGE.write(value.exchange(), out);
          out.whole(value.updateHz());
          WHOLE_NUMBERS.write(value.values(), out);
          out.bool(value.valid());
          out.whole(value.deviceError());
          out.whole(value.connectionError());
        }

        @Override
        ModbusSignalState read(ByteSource in) throws MalformedBytes {
          return new ModbusSignalState(
              in.text(),
              EXCHANGE.read(in),
              in.integer(),
              WHOLE_NUMBERS.read(in),
              in.bool(),
              in.integer(),
              in.integer());
        }
      }.list();

  private static final Form<List<AssemblyPair>> PAIRS =
      new Form<AssemblyPair>() {
        @Override
        void write(AssemblyPair value, ByteSink out) {
          out.whole(value.toPlcId());
          out.whole(value.toPlcBytes());
          out.whole(value.fromPlcId());
          out.whole(value.fromPlcBytes());
        }

        @Override
        AssemblyPair read(ByteSource in) throws MalformedBytes {
          return new AssemblyPair(in.integer(), in.integer(), in.integer(), in.integer());
        }
      }.list();

  private static final Form<Map<Integer, AssemblyData>> DATA =
      new Form<>() {
        @Override
        void write(Map<Integer, AssemblyData> value, ByteSink out) {
          out.count(value.size());
          // in order, so that equal recordings are equal files
          new TreeMap<>(value)
              .forEach(
                  (instance, data) -> {
                    out.whole(instance);
                    out.count(data.size());
                    out.raw(data.toArray());
                  });
        }

        @Override
        Map<Integer, AssemblyData> read(ByteSource in) throws MalformedBytes {
          int count = in.count(2);
          Map<Integer, AssemblyData> data = new HashMap<>();
          for (int i = 0; i < count; i++) {
            int instance = in.integer();
            data.put(instance, AssemblyData.of(in.raw(in.count(1))));
          }
          return data;
        }
      };

  static final Form<AssemblyImage> ASSEMBLIES =
      new Form<>() {
        @Override
        void write(AssemblyImage value, ByteSink out) {
          PAIRS.write(value.pairs(), out);
          DATA.write(value.toPlc(), out);
          DATA.write(value.fromPlc(), out);
        }

        @Override
        AssemblyImage read(ByteSource in) throws MalformedBytes {
          return new AssemblyImage(PAIRS.read(in), DATA.read(in), DATA.read(in));
        }
      };

  private OutsideForms() {}
}
