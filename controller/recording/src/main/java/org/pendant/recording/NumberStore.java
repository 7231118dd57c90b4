package org.pendant.recording;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.lang.ref.PhantomReference;
import java.lang.ref.Reference;
import java.lang.ref.ReferenceQueue;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Number store: the numbers of finished segments in a temporary file rather than in memory. They
 * are nine tenths of a recording. A thread of its own writes; who needs numbers again reads them,
 * any thread. What cannot be written stays in memory.
 *
 * <p>Only the owner can read the file. Where the system allows it, it has no name any more before
 * anything is in it, so that nothing is left of a process that is killed. It consists of places of
 * one size; the place of a segment that nobody refers to any more is used again after Java has
 * collected that.
 */
public final class NumberStore {
  /** Bytes of a place: the numbers of a full segment. */
  static final int PLACE_BYTES = Segment.MAX_NUMBERS * Double.BYTES;

  /** What a ring holds, and as much again that waits to be collected. */
  private static final int STANDARD_PLACES = (int) (2 * RecordingRing.STANDARD_BYTES / PLACE_BYTES);

  /** Segments with less than half a place of numbers stay in memory. */
  private static final int MIN_NUMBERS = Segment.MAX_NUMBERS / 2;

  /** Segments whose numbers are kept in memory after they were read. */
  private static final int CACHED = 8;

  private static final int IDLE_S = 10;

  /** Where temporary files are on a disk; the folder for all of them may be in memory. */
  private static final Path ON_DISK = Path.of("/var/tmp");

  private final FileMaker maker;
  private final int mostPlaces;
  private final Executor worker;
  private final Consumer<IOException> failed;
  private final ReferenceQueue<Place> collected = new ReferenceQueue<>();
  private final Set<Use> used = ConcurrentHashMap.newKeySet();
  private final Queue<Integer> free = new ConcurrentLinkedQueue<>();
  private final Map<Place, double[]> cache =
      new LinkedHashMap<>(2 * CACHED, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<Place, double[]> eldest) {
          return size() > CACHED;
        }
      };

  // of the worker only
  private Optional<TemporaryFile> file = Optional.empty();
  private int places;
  private boolean told;

  /** Makes the file when it is needed. */
  interface FileMaker {
    /** A new file. */
    TemporaryFile make() throws IOException;
  }

  /** One file, opened twice, so that readers do not wait for the writer. */
  record TemporaryFile(RandomAccessFile writing, RandomAccessFile reading) {
    static TemporaryFile in(Path folder) throws IOException {
      Path path = Files.createTempFile(folder, "pendant-recording-", ".tmp");
      try {
        return new TemporaryFile(
            new RandomAccessFile(path.toFile(), "rw"), new RandomAccessFile(path.toFile(), "r"));
      } finally {
        delete(path);
      }
    }

    private static void delete(Path path) {
      try {
        Files.delete(path);
      } catch (IOException e) {
        // Windows does not delete what is open
        path.toFile().deleteOnExit();
      }
    }
  }

  /** The numbers of a segment in the file. */
  private final class Place implements Supplier<double[]> {
    private final RandomAccessFile reading;
    private final int number;
    private final int count;

    Place(RandomAccessFile reading, int number, int count) {
      this.reading = reading;
      this.number = number;
      this.count = count;
    }

    @Override
    public double[] get() {
      synchronized (cache) {
        double[] known = cache.get(this);
        if (known != null) {
          return known;
        }
      }
      double[] numbers = read();
      synchronized (cache) {
        cache.put(this, numbers);
      }
      return numbers;
    }

    private double[] read() {
      byte[] bytes = new byte[count * Double.BYTES];
      try {
        synchronized (reading) {
          reading.seek((long) number * PLACE_BYTES);
          reading.readFully(bytes);
        }
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      } finally {
        // until here nothing else may be written to the place
        Reference.reachabilityFence(this);
      }
      double[] numbers = new double[count];
      ByteBuffer.wrap(bytes).order(ByteOrder.nativeOrder()).asDoubleBuffer().get(numbers);
      return numbers;
    }
  }

  /** Knows which place is free when nobody refers to it any more. */
  private static final class Use extends PhantomReference<Place> {
    private final int number;

    Use(Place place, ReferenceQueue<Place> collected) {
      super(place, collected);
      number = place.number;
    }
  }

  /**
   * A store for the rings of one session; the file is made when it is needed.
   *
   * @param failed told once when the file cannot be written, in a thread of the store
   */
  public NumberStore(Consumer<IOException> failed) {
    this(() -> TemporaryFile.in(temporaryFolder()), STANDARD_PLACES, worker(), failed);
  }

  NumberStore(FileMaker maker, int mostPlaces, Executor worker, Consumer<IOException> failed) {
    this.maker = maker;
    this.mostPlaces = mostPlaces;
    this.worker = worker;
    this.failed = failed;
  }

  private static Path temporaryFolder() {
    return Files.isDirectory(ON_DISK) && Files.isWritable(ON_DISK)
        ? ON_DISK
        : Path.of(System.getProperty("java.io.tmpdir"));
  }

  /** A thread that ends while there is nothing to do. */
  private static Executor worker() {
    return new ThreadPoolExecutor(
        0,
        1,
        IDLE_S,
        TimeUnit.SECONDS,
        new LinkedBlockingQueue<>(),
        Thread.ofPlatform().daemon().name("recording store").factory());
  }

  /** How much of the file is taken, also by what Java has yet to collect. Any thread. */
  public long usedBytes() {
    reclaim();
    return (long) used.size() * PLACE_BYTES;
  }

  /** Has the numbers of a segment, to which nothing is appended any more, put into the file. */
  void keep(Segment finished) {
    if (finished.numberCount() >= MIN_NUMBERS) {
      worker.execute(() -> write(finished));
    }
  }

  private void write(Segment segment) {
    if (segment.numbersAreAway()) {
      return;
    }
    Optional<Integer> place = place();
    if (place.isEmpty()) {
      return;
    }
    int number = place.get();
    int count = segment.numberCount();
    byte[] bytes = new byte[count * Double.BYTES];
    ByteBuffer.wrap(bytes)
        .order(ByteOrder.nativeOrder())
        .asDoubleBuffer()
        .put(segment.numbers(), 0, count);
    try {
      if (file.isEmpty()) {
        file = Optional.of(maker.make());
      }
      TemporaryFile open = file.get();
      open.writing().seek((long) number * PLACE_BYTES);
      open.writing().write(bytes);
      Place written = new Place(open.reading(), number, count);
      used.add(new Use(written, collected));
      segment.numbersAreIn(written);
    } catch (IOException e) {
      free.add(number);
      if (!told) {
        told = true;
        failed.accept(e);
      }
    }
  }

  private Optional<Integer> place() {
    reclaim();
    Integer again = free.poll();
    if (again != null) {
      return Optional.of(again);
    }
    if (places == mostPlaces) {
      return Optional.empty();
    }
    places++;
    return Optional.of(places - 1);
  }

  private void reclaim() {
    Reference<? extends Place> next = collected.poll();
    while (next != null) {
      if (next instanceof Use use && used.remove(use)) {
        free.add(use.number);
      }
      next = collected.poll();
    }
  }
}
