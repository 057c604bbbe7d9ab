"""Files on their way from pages: how many and how large they may be, and what of them is still to come."""

import dataclasses

from .messages import UPLOAD_PART_BYTES, FileTransferPart, FileTransferStartUpload, Refused

MAX_UPLOAD_BYTES = 5 * 1024 * 1024
MAX_UPLOADS_PER_TAB = 2
MAX_UPLOADS = 16
"""Uploads under way at once, which viser holds in memory: at most 80 MiB."""


@dataclasses.dataclass
class _Upload:
    tab: object
    source_component_uuid: str
    size_bytes: int
    missing_parts: set[int]


class Uploads:
    """The uploads under way; viser has their bytes. A tab is whatever stands for one connection."""

    def __init__(self) -> None:
        self._under_way: dict[str, _Upload] = {}

    def forget(self, tab: object) -> None:
        """Drop the uploads of a tab that is gone."""
        self._under_way = {key: upload for key, upload in self._under_way.items() if upload.tab is not tab}

    def start(self, tab: object, message: FileTransferStartUpload) -> None:
        """Expect the parts of a file.

        Raises:
            Refused: "oversized upload", or "upload" for one too many or whose parts do not add up.
        """
        if message.size_bytes > MAX_UPLOAD_BYTES:
            raise Refused("oversized upload")
        if (
            message.part_count != -(-message.size_bytes // UPLOAD_PART_BYTES)
            or message.transfer_uuid in self._under_way
            or len(self._under_way) >= MAX_UPLOADS
            or sum(upload.tab is tab for upload in self._under_way.values()) >= MAX_UPLOADS_PER_TAB
        ):
            raise Refused("upload")
        if message.part_count:
            self._under_way[message.transfer_uuid] = _Upload(
                tab, message.source_component_uuid, message.size_bytes, set(range(message.part_count))
            )

    def take_part(self, tab: object, message: FileTransferPart) -> None:
        """Note that a part has come.

        Raises:
            Refused: "upload", if it is not one that the tab still has to send.
        """
        upload = self._under_way.get(message.transfer_uuid)
        offset = message.part_index * UPLOAD_PART_BYTES
        if (
            upload is None
            or upload.tab is not tab
            or upload.source_component_uuid != message.source_component_uuid
            or message.part_index not in upload.missing_parts
            or len(message.content) != min(UPLOAD_PART_BYTES, upload.size_bytes - offset)
        ):
            raise Refused("upload")
        upload.missing_parts.remove(message.part_index)
        if not upload.missing_parts:
            del self._under_way[message.transfer_uuid]
