//! rur, which writes and hangs up at once: load and play by the dashboard, a script by port 30002.
//!
//! # serve: --ready --programs {folder}

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

const PATIENCE: Duration = Duration::from_secs(30);

/// A connection of our own, which looks at what the client has done.
struct Dashboard {
    reader: BufReader<TcpStream>,
}

impl Dashboard {
    fn connect(host: &str) -> Dashboard {
        let stream = TcpStream::connect((host, 29999)).expect("no dashboard");
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let mut dashboard = Dashboard { reader: BufReader::new(stream) };
        dashboard.line();
        dashboard
    }

    fn line(&mut self) -> String {
        let mut line = String::new();
        self.reader.read_line(&mut line).expect("no answer");
        line.trim_end().to_string()
    }

    fn ask(&mut self, question: &str) -> String {
        self.reader.get_mut().write_all(format!("{question}\n").as_bytes()).unwrap();
        self.line()
    }

    fn until(&mut self, question: &str, answer: &str) {
        let end = Instant::now() + PATIENCE;
        loop {
            let found = self.ask(question);
            if found == answer {
                println!("{question}: {found}");
                return;
            }
            assert!(Instant::now() < end, "{question}: expected {answer}, found {found}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

fn main() {
    let host = std::env::args().nth(1).expect("usage: rust_rur HOST");
    let mut dashboard = Dashboard::connect(&host);

    std::fs::write("turning.script", "def turning():\n  while True:\n    sync()\n  end\nend\n").unwrap();
    rur::dashboard_server::load(&host, "turning.script".to_string());
    dashboard.until("get loaded program", "Loaded program: /programs/turning.script");
    rur::dashboard_server::play(&host);
    dashboard.until("programState", "PLAYING turning.script");

    // it takes the place of the one that would play for ever
    std::fs::write("sent.script", "def sent():\n  set_standard_digital_out(3, True)\nend\n").unwrap();
    rur::script::send(&host, 30002, "sent.script");
    dashboard.until("programState", "STOPPED turning.script");
}
