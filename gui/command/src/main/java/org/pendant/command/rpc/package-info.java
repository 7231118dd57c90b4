/**
 * JSON-RPC over standard input and output: programs in other languages load programs into robots,
 * let their time pass and read what happens (docs/python.md). {@link
 * org.pendant.command.rpc.RpcServer} is the class to open first: it reads lines with {@link
 * org.pendant.command.rpc.LineReader} and has them answered by a {@link
 * org.pendant.command.rpc.Dispatcher}, whose methods stand in a class for each topic.
 */
package org.pendant.command.rpc;
