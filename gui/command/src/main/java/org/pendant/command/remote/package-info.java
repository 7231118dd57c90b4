/** A robot that tests run on, reached by its ports. */
package org.pendant.command.remote;
