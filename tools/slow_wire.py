"""Connection of two network interfaces whose packets are delayed, reordered and lost, as by netem,
for kernels without it.

    python3 slow_wire.py ONE OTHER DELAY JITTER LOSS

Creates the two interfaces (TUN) and prints "ready"; the caller moves each into a namespace. DELAY
and JITTER are in milliseconds, LOSS in percent of the packets. Ends at SIGTERM, and prints the
numbers of packets delivered and lost.
"""
import fcntl
import heapq
import os
import random
import select
import signal
import struct
import sys
import time

TUNSETIFF = 0x400454CA
TUN_WITHOUT_HEAD = 0x0001 | 0x1000
LARGEST_PACKET = 65536


def interface(name):
    descriptor = os.open("/dev/net/tun", os.O_RDWR)
    fcntl.ioctl(descriptor, TUNSETIFF, struct.pack("16sH22x", name.encode(), TUN_WITHOUT_HEAD))
    os.set_blocking(descriptor, False)
    return descriptor


class Ended(Exception):
    """SIGTERM was received."""


def end(*_):
    raise Ended


def carry(ends, delay, jitter, loss, counts):
    other = {ends[0]: ends[1], ends[1]: ends[0]}
    choice = random.Random(1)
    under_way = []  # arrival time, number, socket and data of each packet
    while True:
        wait = max(0, under_way[0][0] - time.monotonic()) if under_way else None
        for source in select.select(ends, [], [], wait)[0]:
            try:
                packet = os.read(source, LARGEST_PACKET)
            except OSError:  # not listening yet
                time.sleep(0.001)
                continue
            if choice.random() < loss:
                counts["lost"] += 1
                continue
            counts["carried"] += 1
            arrival = time.monotonic() + delay + jitter * choice.uniform(-1, 1)
            heapq.heappush(under_way, (arrival, counts["carried"], other[source], packet))
        while under_way and under_way[0][0] <= time.monotonic():
            _, _, target, packet = heapq.heappop(under_way)
            try:
                os.write(target, packet)
            except OSError:
                counts["lost"] += 1


def main():
    names = sys.argv[1:3]
    delay, jitter, loss = (float(word) for word in sys.argv[3:])
    ends = [interface(name) for name in names]
    counts = {"carried": 0, "lost": 0}
    signal.signal(signal.SIGTERM, end)
    print("ready", flush=True)
    try:
        carry(ends, delay / 1000, jitter / 1000, loss / 100, counts)
    except Ended:
        print(f"{counts['carried']} packets carried, {counts['lost']} lost", flush=True)


if __name__ == "__main__":
    main()
